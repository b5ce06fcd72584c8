#pragma once
/**
 * @file crew_sizes.h
 * The order of grains by size, the largest first and equal ones by number: each rank sorts an equal
 * share of them, and rank 0 merges what they have next. So no rank has a list of all.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.   Test  tests/step/test_crew_places.c
 */

#include "base/sort.h"
#include "parallel/ranks.h"

/** All zero: no grains. */
typedef struct clod_crew_sizes {
    clod_sort_item *own; ///< [count] of this rank: key that ascends with size, number; owned
    size_t count, own_room, sent;
    size_t given; ///< of all ranks
    bool sorted;
    clod_sort_item *pool, *scratch; ///< of rank 0: what ranks have next; owned
    size_t pooled, ready, pool_room, scratch_room;
} clod_crew_sizes;

/**
 * Give the radii of the next grains: grain number k goes to rank k modulo their number.
 *
 * @param radius  [count] of rank 0 [m]; positive
 * @param count   the same on all ranks
 * @return        false without memory on any rank
 */
bool clod_crew_sizes_give(clod_crew_sizes *self, clod_ranks *ranks, const double *radius,
                          size_t count, clod_status *status);

/**
 * Have the numbers of the next grains in pool[0 to ready) of rank 0, as `index`; the ones before are
 * forgotten. None: that was all.
 *
 * @param chunk  that each rank sends
 * @return       false without memory on any rank
 */
bool clod_crew_sizes_next(clod_crew_sizes *self, clod_ranks *ranks, size_t chunk,
                          clod_status *status);

void clod_crew_sizes_fini(clod_crew_sizes *self);
