#pragma once
/**
 * @file bits.h
 * Comparison of two states bit for bit: everything that a checkpoint holds.
 */

#include <stdbool.h>
#include <string.h>

#include "state/state.h"
#include "support/check.h"

static inline bool bits_same_grains(const clod_grains *a, const clod_grains *b)
{
    const size_t n = a->count;
    return n == b->count && memcmp(a->position, b->position, n * sizeof *a->position) == 0 &&
           memcmp(a->velocity, b->velocity, n * sizeof *a->velocity) == 0 &&
           memcmp(a->angular_velocity, b->angular_velocity, n * sizeof *a->angular_velocity) ==
               0 &&
           memcmp(a->load, b->load, n * sizeof *a->load) == 0 &&
           memcmp(a->id, b->id, n * sizeof *a->id) == 0 &&
           memcmp(a->material, b->material, n * sizeof *a->material) == 0;
}

/** Contacts as clod_step_export leaves them. */
static inline bool bits_same_contacts(const clod_state *a, const clod_state *b)
{
    if (a->contact_count != b->contact_count ||
        a->wall_contact_count != b->wall_contact_count) {
        return false;
    }
    for (size_t k = 0; k < a->contact_count; k++) {
        const clod_contact *x = &a->contacts[k];
        const clod_contact *y = &b->contacts[k];
        if (x->i != y->i || x->j != y->j || x->shape != y->shape ||
            memcmp(x->history, y->history, sizeof x->history) != 0) {
            return false;
        }
    }
    return true;
}

/** Everything of the walls that changes during a run. */
static inline bool bits_same_walls(const clod_walls *a, const clod_walls *b)
{
    bool same = a->count == b->count;
    for (int32_t w = 0; w < a->count && same; w++) {
        const clod_wall *x = &a->wall[w];
        const clod_wall *y = &b->wall[w];
        const size_t force = offsetof(clod_wall, servo_velocity);
        same = memcmp(&x->shift, &y->shift, sizeof x->shift) == 0 &&
               memcmp(&x->angle, &y->angle, sizeof x->angle) == 0 &&
               memcmp(&x->travel, &y->travel, sizeof x->travel) == 0 &&
               memcmp(&x->turned, &y->turned, sizeof x->turned) == 0 &&
               memcmp((const char *)x + force, (const char *)y + force,
                      offsetof(clod_wall, wear) - force) == 0 &&
               (x->wear == NULL ||
                memcmp(x->wear, y->wear, (size_t)x->wear_rows * sizeof *x->wear) == 0);
    }
    return same;
}

/** Fail unless the two states have the same bits. */
#define check_same_bits(a, b)                                                                  \
    do {                                                                                       \
        assert_true(bits_same_grains(&(a)->grains, &(b)->grains));                             \
        assert_true(bits_same_walls(&(a)->walls, &(b)->walls));                                \
        assert_true(bits_same_contacts((a), (b)));                                             \
        assert_int_equal((a)->step, (b)->step);                                                \
        assert_memory_equal(&(a)->time, &(b)->time, sizeof(a)->time);                          \
        assert_memory_equal(&(a)->ledger, &(b)->ledger, sizeof(a)->ledger);                    \
        assert_memory_equal(&(a)->build_motion, &(b)->build_motion, sizeof(a)->build_motion);  \
        assert_memory_equal(&(a)->build_skin, &(b)->build_skin, sizeof(a)->build_skin);        \
    } while (0)
