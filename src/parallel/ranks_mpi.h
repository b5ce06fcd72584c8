#pragma once
/**
 * @file ranks_mpi.h
 * Ranks by MPI, where clod was built with it. Only ranks_mpi.c knows it.
 */

#include "parallel/ranks.h"

/** Whether mpirun, or srun with PMIx or PMI, has started this process. */
bool clod_ranks_mpi_started(void);

/** How many processes it has started with this one: 1 where nobody has; 0: neither it nor MPI, if that
 *  runs in this process, says. */
int clod_ranks_mpi_processes(void);

/**
 * Join the ranks that it has started, or those of a communicator. MPI begins, and ends with
 * clod_ranks_mpi_close, unless somebody else has begun it.
 *
 * @param self          [out] clod_ranks_mpi_close when it is not needed any more
 * @param communicator  MPI's number of it (MPI_Comm_c2f), all of whose processes make this call;
 *                      NULL: all that were started
 * Errors  CLOD_USAGE: this process sees no other rank, but there are others, or may be, as its
 *         starter says (this clod knows no MPI, or another one): each would compute all;
 *         a communicator that is none, or no MPI. CLOD_FAILED.
 */
bool clod_ranks_mpi_open(clod_ranks *self, const int *communicator, clod_status *status);

void clod_ranks_mpi_close(clod_ranks *self);
