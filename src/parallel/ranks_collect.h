#pragma once
/**
 * @file ranks_collect.h
 * Bytes of all ranks to rank 0, each as many as it has: one message of each for the number, and one
 * for the bytes.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.   Test  tests/parallel/test_rank_messages.c
 */

#include "base/bytes.h"
#include "parallel/ranks.h"

/**
 * Collect them.
 *
 * @param all    [out] of rank 0: one behind the other, in the order of ranks; others' is not touched
 * @param begin  [size + 1] [out] of rank 0: where those of each rank begin in it
 * @return       false without memory on any rank, on all alike
 */
bool clod_ranks_collect(clod_ranks *self, const clod_bytes *mine, clod_bytes *all,
                        size_t *begin, clod_status *status);

/** The way back: from rank 0, where they lie as they were collected, the bytes of this rank. */
void clod_ranks_return(clod_ranks *self, const void *all, const size_t *begin, void *mine,
                       size_t bytes);
