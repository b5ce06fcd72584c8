#pragma once
/**
 * @file near_walk.h
 * A walk along the near pairs in ascending (i, j). A pair does not know where its history is:
 * in each group the pairs stand in this very order, so the walk knows.
 */

#include "base/memory.h"
#include "step/near.h"

/** Pairs after which what has been read of their histories is given back. */
#define CLOD_NEAR_GIVE_BACK 4096

/**
 * Give back histories that have been read, in a large bed; in a small one that would cost time
 * at every list.
 *
 * @param array  of so many `bytes`, begins at a huge page
 * @param given  how far it has been given back before
 * @param read   how far it has been read
 * @return       how far it is given back now
 */
static inline size_t clod_near_give_back(void *array, size_t bytes, size_t given, size_t read)
{
    const size_t whole = read / CLOD_MEMORY_HUGE_PAGE * CLOD_MEMORY_HUGE_PAGE;
    if (bytes < CLOD_MEMORY_LARGE || whole <= given) {
        return given;
    }
    clod_memory_give_back((char *)array + given, whole - given, bytes);
    return whole;
}

typedef struct clod_near_walk {
    const clod_near *near;
    const clod_pairs *pairs;
    const clod_laws *laws;
    const uint16_t *material;
    size_t *fill; ///< [groups] pairs of each group that have gone by; set to 0 before the walk
    size_t next;  ///< candidate to look at
    int part;     ///< of i
    // the pair
    int32_t i, j;
    size_t group;
} clod_near_walk;

/** Go on to the next near pair; false: there is none. */
static inline bool clod_near_walk_on(clod_near_walk *self)
{
    const clod_pairs *pairs = self->pairs;
    for (; self->next < pairs->count; self->next++) {
        while (self->next >= pairs->start[self->i + 1]) {
            self->i++;
        }
        if (pairs->item[self->next].near != 0) {
            break;
        }
    }
    if (self->next == pairs->count) {
        return false;
    }
    self->j = (int32_t)pairs->item[self->next].j;
    const size_t *part_start = self->near->part_start;
    while ((size_t)self->i >= part_start[self->part + 1]) {
        self->part++;
    }
    int later = self->part;
    while ((size_t)self->j >= part_start[later + 1]) {
        later++;
    }
    const int32_t law =
        self->laws->count == 1
            ? 0
            : clod_laws_index(self->laws, self->material[self->i], self->material[self->j]);
    self->group = later == self->part ? clod_near_group(self->near, later, law)
                                      : clod_near_group_between(self->near, later, law);
    self->next++;
    return true;
}

/** Lane of the pair, counted over all blocks; once for each pair. */
static inline size_t clod_near_walk_lane(clod_near_walk *self)
{
    return self->near->pairs.group_start[self->group] * CLOD_LANES + self->fill[self->group]++;
}

/** At the beginning; `fill` is scratch of the list of pairs. */
static inline clod_near_walk clod_near_walk_begin(const clod_near *near,
                                                  const clod_pairs *pairs,
                                                  const clod_state *state,
                                                  const clod_laws *laws)
{
    clod_near_walk walk = {.near = near,
                           .pairs = pairs,
                           .laws = laws,
                           .material = state->grains.material,
                           .fill = near->pairs.group_count + clod_near_groups(near)};
    for (size_t q = 0; q < clod_near_groups(near); q++) {
        walk.fill[q] = 0;
    }
    return walk;
}
