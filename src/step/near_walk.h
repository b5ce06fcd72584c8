#pragma once
/**
 * @file near_walk.h
 * A walk along the near pairs of a part, with the group of each; and memory of large beds that
 * is given back as it has been read.
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

/** Near pairs of the grains of one part, in ascending (i, j). */
typedef struct clod_near_walk {
    const clod_near_job *job;
    size_t next, end; ///< candidates
    int part;
    // the pair
    int32_t i, j;
    size_t group;
} clod_near_walk;

/** Before the first pair of a part. */
static inline clod_near_walk clod_near_walk_begin(const clod_near_job *job, int part)
{
    const uint32_t *start = job->neighbour->pairs.start;
    const size_t *row = &job->near->part_start[part];
    return (clod_near_walk){.job = job,
                            .next = start[row[0]],
                            .end = start[row[1]],
                            .part = part,
                            .i = (int32_t)row[0]};
}

/** Go on to the next near pair; false: there is none. */
static inline bool clod_near_walk_on(clod_near_walk *self)
{
    const clod_pairs *pairs = &self->job->neighbour->pairs;
    while (self->next < self->end && pairs->item[self->next].near == 0) {
        self->next++;
    }
    if (self->next == self->end) {
        return false;
    }
    while (self->next >= pairs->start[self->i + 1]) {
        self->i++;
    }
    self->j = (int32_t)pairs->item[self->next++].j;
    const clod_near *near = self->job->near;
    int later = self->part;
    while ((size_t)self->j >= near->part_start[later + 1]) {
        later++;
    }
    const clod_laws *laws = self->job->laws;
    const uint16_t *material = self->job->state->grains.material;
    const int32_t law =
        laws->count == 1 ? 0 : clod_laws_index(laws, material[self->i], material[self->j]);
    self->group = later == self->part ? clod_near_group(near, later, law)
                                      : clod_near_group_between(near, later, law);
    return true;
}
