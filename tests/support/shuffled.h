#pragma once
/**
 * @file shuffled.h
 * A state whose rows and contacts stand in another order.
 */

#include "state/state.h"
#include "support/check.h"
#include "support/dice.h"

/** Row g of `from` becomes row to[g]. */
static inline void shuffled_rows(void *array, const void *from, size_t count, size_t size,
                                 const size_t *to)
{
    for (size_t g = 0; g < count; g++) {
        memcpy((char *)array + to[g] * size, (const char *)from + g * size, size);
    }
}

static inline void shuffled_order(size_t *order, size_t count, dice *roll)
{
    for (size_t k = 0; k < count; k++) {
        order[k] = k;
    }
    for (size_t k = count; k > 1; k--) {
        const size_t other = (size_t)dice_pick(roll, (int)k);
        const size_t kept = order[k - 1];
        order[k - 1] = order[other];
        order[other] = kept;
    }
}

static inline void shuffled_contacts(clod_contact *contacts, size_t count, const size_t *to,
                                     bool walls, dice *roll)
{
    for (size_t k = 0; k < count; k++) {
        contacts[k].i = (int32_t)to[contacts[k].i];
        contacts[k].j = walls ? contacts[k].j : (int32_t)to[contacts[k].j];
        if (!walls && contacts[k].i > contacts[k].j) {
            clod_contact_turn(&contacts[k]);
        }
    }
    for (size_t k = count; k > 1; k--) {
        const size_t other = (size_t)dice_pick(roll, (int)k);
        const clod_contact kept = contacts[k - 1];
        contacts[k - 1] = contacts[other];
        contacts[other] = kept;
    }
}

/** A copy of a state whose rows and contacts stand in another order. */
static inline clod_state shuffled(const clod_state *from, uint64_t seed)
{
    clod_status status = {0};
    clod_state copy = {0};
    dice roll = {seed};
    const size_t n = from->grains.count;
    size_t *to = clod_memory_alloc(n, sizeof *to);
    assert_true(clod_state_copy(&copy, from, &status));
    shuffled_order(to, n, &roll);
    const clod_grains *g = &from->grains;
    shuffled_rows(copy.grains.position, g->position, n, sizeof *g->position, to);
    shuffled_rows(copy.grains.velocity, g->velocity, n, sizeof *g->velocity, to);
    shuffled_rows(copy.grains.angular_velocity, g->angular_velocity, n,
                  sizeof *g->angular_velocity, to);
    shuffled_rows(copy.grains.load, g->load, n, sizeof *g->load, to);
    shuffled_rows(copy.grains.id, g->id, n, sizeof *g->id, to);
    shuffled_rows(copy.grains.material, g->material, n, sizeof *g->material, to);
    shuffled_rows(copy.build_position, from->build_position, n, sizeof *from->build_position,
                  to);
    const size_t walls = from->wall_contact_count, pairs = from->contact_count - walls;
    shuffled_contacts(copy.contacts, pairs, to, false, &roll);
    shuffled_contacts(copy.contacts + pairs, walls, to, true, &roll);
    clod_memory_free(to);
    return copy;
}
