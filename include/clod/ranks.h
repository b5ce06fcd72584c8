#pragma once
/**
 * @file ranks.h
 * Processes that mpirun (or srun) has started to compute one case together: ranks. Rank 0 runs the
 * case and writes, or drives a simulation of clod/sim.h; the others compute their parts when it asks
 * them to. docs/ranks.md says what works on several.
 *
 *     clod_ranks *ranks = clod_ranks_open(&status);         // in every process
 *     if (ranks != NULL && clod_ranks_number(ranks) == 0) { // the whole program, in one of them
 *         const clod_sim_options options = {.ranks = ranks};
 *         clod_sim *sim = clod_sim_create_from_file("case.yaml", &options, &status);
 *         ...
 *         clod_sim_destroy(&sim);
 *     }
 *     clod_ranks_close(&ranks); // the others compute here until rank 0 closes too
 *
 * examples/on_ranks.c is a whole program. A NULL where an argument is needed: see clod/status.h.
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
 * MPI begins with this call and ends with clod_ranks_close, and cannot begin again: open ranks once,
 * for one simulation after the other. Where the program has begun MPI itself before, it also ends
 * it, and may open and close ranks as often as it likes.
 *
 * @return  owned (clod_ranks_close), or NULL
 * Errors  CLOD_USAGE: several processes were started, and this clod was built without MPI; MPI has
 *         ended. CLOD_FAILED: MPI, memory.   Threads  the one that has begun MPI, or the first.
 * Test    tests/parallel/test_mpirun.py, test_mpirun_library.py
 */
clod_ranks *clod_ranks_open(clod_status *status);

/**
 * The same of the processes in a communicator of MPI, which the program has begun: groups of ranks
 * can step a simulation each.
 *
 * @param communicator  MPI_Comm_c2f of it; in Python py2f() of mpi4py's. All its processes make this
 *                      call. clod copies it; messages of the program do not meet clod's
 * Errors  CLOD_USAGE: MPI does not run in this process, or is another one than clod's; the
 *         communicator is MPI_COMM_NULL or lies between two groups. As clod_ranks_open.
 * Test    tests/parallel/test_mpirun_library.py
 */
clod_ranks *clod_ranks_open_group(int communicator, clod_status *status);

/** Number of this rank, 0 to size - 1. */
int clod_ranks_number(const clod_ranks *self);

/** How many ranks there are. */
int clod_ranks_size(const clod_ranks *self);

/** Compute what rank 0 asks for, until that closes. On rank 0, and after that, it returns at once. */
void clod_ranks_serve(clod_ranks *self);

/**
 * Leave the ranks, and null the pointer; NULL is fine. On rank 0 the others are let go; on these it
 * serves until then. A simulation that still uses the ranks can be read and destroyed from then on.
 *
 * A program that ends on rank 0 without this call leaves the others waiting, until mpirun ends them;
 * its status then tells that.
 */
void clod_ranks_close(clod_ranks **self);

#ifdef __cplusplus
}
#endif
