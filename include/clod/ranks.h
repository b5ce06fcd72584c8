#pragma once
/**
 * @file ranks.h
 * Processes that mpirun (or srun) has started to compute one case together: ranks. Rank 0 runs the
 * case and writes; the others compute their parts when it asks them to. docs/ranks.md says what
 * works on several. A NULL where an argument is needed: see clod/status.h.
 */

#include <stdbool.h>

#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clod_ranks clod_ranks;

/**
 * Join the ranks of this run; a process that nobody has started with others is one rank alone.
 *
 * @return  owned (clod_ranks_close), or NULL
 * Errors  CLOD_USAGE: several processes were started, and this clod was built without MPI;
 *         CLOD_FAILED: MPI, memory.   Threads  once in a process, from its first thread.
 * Test    tests/cli/test_mpirun.py
 */
clod_ranks *clod_ranks_open(clod_status *status);

/** Number of this rank, 0 to size - 1. */
int clod_ranks_number(const clod_ranks *self);

/** How many ranks there are. */
int clod_ranks_size(const clod_ranks *self);

/** Compute what rank 0 asks for, until that closes. Threads: all ranks but 0. */
void clod_ranks_serve(clod_ranks *self);

/** Leave the ranks, and null the pointer; the others return from clod_ranks_serve when rank 0
 *  does. NULL is fine. */
void clod_ranks_close(clod_ranks **self);

#ifdef __cplusplus
}
#endif
