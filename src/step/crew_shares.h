#pragma once
/**
 * @file crew_shares.h
 * What goes from each rank to each, before a bed is stepped.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.
 */

#include "parallel/ranks.h"

typedef struct clod_crew_shares {
    clod_bytes *out; ///< [ranks] owned
    clod_bytes in;   ///< owned
    size_t *begin;   ///< [ranks + 1] where those of each rank begin in it; owned
} clod_crew_shares;

/** Nothing yet; false without memory on any rank. clod_crew_shares_fini in any case. */
bool clod_crew_shares_init(clod_crew_shares *self, clod_ranks *ranks, clod_status *status);

/** Have `out` of all ranks in `in`; false without memory on any rank. */
bool clod_crew_shares_swap(clod_crew_shares *self, clod_ranks *ranks, clod_status *status);

/** Have `out` for rank 0 of all ranks in its `in`; false without memory on any rank. */
bool clod_crew_shares_collect(clod_crew_shares *self, clod_ranks *ranks, clod_status *status);

void clod_crew_shares_fini(clod_crew_shares *self, const clod_ranks *ranks);
