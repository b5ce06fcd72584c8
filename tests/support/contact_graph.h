#pragma once
/**
 * @file contact_graph.h
 * Grains and contacts put down by hand: what measures of the graph of contacts look at. The
 * pull-off force of a contact stands where its plastic overlap does.
 */

#include "base/memory.h"
#include "state/contact_source.h"
#include "support/check.h"

#define GRAPH_DENSITY 2500.0

typedef struct contact_graph {
    clod_state state;
    clod_contact_list list;
    clod_contact_source contacts;
} contact_graph;

static inline clod_contact_strength graph_strength(const void *laws,
                                                   const clod_contact *contact)
{
    (void)laws;
    return (clod_contact_strength){contact->history[0], 2.0 * contact->history[0]};
}

/** No grains, room for so many contacts; gravity 10 m/s2. */
static inline void graph_init(contact_graph *self, size_t contacts)
{
    *self = (contact_graph){0};
    self->state.gravity[2] = -10.0;
    self->state.contacts = clod_memory_alloc(contacts, sizeof *self->state.contacts);
    self->state.contact_capacity = contacts;
    self->contacts = clod_contact_source_of(&self->list, &self->state);
    self->contacts.strength = graph_strength;
}

static inline void graph_fini(contact_graph *self)
{
    clod_state_fini(&self->state);
}

/** Add a grain at a place. */
static inline int32_t graph_grain(contact_graph *self, uint64_t id, double x, double z,
                                  double radius)
{
    clod_status status;
    const double place[4] = {x, 0.0, z, radius};
    const double none[3] = {0.0, 0.0, 0.0};
    assert_true(
        clod_grains_add(&self->state.grains, place, none, none, GRAPH_DENSITY, 0, id, &status));
    return (int32_t)self->state.grains.count - 1;
}

/** Add a contact that pulls with so many weights of row i; pairs before walls. */
static inline void graph_touch(contact_graph *self, int32_t i, int32_t j, double weights)
{
    assert_true(self->state.contact_count < self->state.contact_capacity);
    assert_int_equal(self->state.wall_contact_count, 0);
    clod_contact *contact = &self->state.contacts[self->state.contact_count++];
    *contact = (clod_contact){.i = i < j ? i : j, .j = i < j ? j : i, .shape = -1};
    contact->history[0] = weights * 10.0 * self->state.grains.velocity[i][3];
}

static inline void graph_touch_wall(contact_graph *self, int32_t i, int32_t wall)
{
    assert_true(self->state.contact_count < self->state.contact_capacity);
    self->state.contacts[self->state.contact_count++] = (clod_contact){.i = i, .j = wall};
    self->state.wall_contact_count++;
}
