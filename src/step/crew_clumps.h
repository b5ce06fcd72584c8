#pragma once
/**
 * @file crew_clumps.h
 * The clumps that grains were in when somebody looked: they take them along, so what leaves is counted by
 * its clump. Each rank has those of its grains (measure/clumps.h), but for what rank 0 has found in a
 * whole state, at a beginning or when the bed was gathered for something else.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.   Test  tests/parallel/test_mpirun.py
 */

#include "parallel/ranks.h"
#include "state/state.h"

/**
 * The clumps of all grains from the whole state to the ranks' grains.
 *
 * @param whole  of rank 0; NULL on other ranks
 * @param part   this rank's state
 * @return       false without memory on any rank, on all alike
 */
bool clod_crew_clumps_tell(clod_ranks *ranks, const clod_state *whole, clod_state *part,
                           clod_status *status);
