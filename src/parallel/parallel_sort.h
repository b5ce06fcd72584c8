#pragma once
/**
 * @file parallel_sort.h
 * The sort of base/sort.h by several threads, with the same order for any number of parts and
 * threads; allocates nothing.
 */

#include "base/sort.h"
#include "parallel/barrier.h"
#include "parallel/threads.h"

typedef struct clod_parallel_sort {
    clod_sort_item *items, *scratch; ///< [count]; both are overwritten
    size_t count;
    clod_sort_part *part; ///< [parts] scratch
    int parts;            ///< that the items are cut into
} clod_parallel_sort;

/**
 * Sort items by key, keeping the order of equal keys: every thread calls this with the parts that
 * it does. The items of all parts are there before the first one comes, and all have come out
 * before any of them is used.
 *
 * @param parts    numbers of parts; each is done by one thread
 * @param barrier  of these threads
 * @return         items or scratch: where the sorted items are, the same for all
 * Errors  none.   Threads  at the same time.   Test  tests/parallel/test_parallel_sort.c
 */
clod_sort_item *clod_parallel_sort_do(const clod_parallel_sort *self, clod_chunk parts,
                                      clod_barrier *barrier);
