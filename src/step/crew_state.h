#pragma once
/**
 * @file crew_state.h
 * What every rank of a crew knows of the bed beside its grains: walls, laws, numbers. Rank 0 tells
 * it to the others.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.
 * Test     tests/step/test_ranks.c, test_ranks_pages.c
 */

#include "law/law.h"
#include "parallel/ranks.h"
#include "state/state.h"

/** Copy all of a state but grains, contacts, and what its walls own. */
void clod_crew_state_copy(clod_state *to, const clod_state *from);

/** Give the memory of grains and contacts back to the system, which are elsewhere from now on: what
 *  is in their rows is not defined then, room for them stays. */
void clod_crew_state_forget(clod_state *state);

/** The same from the state of rank 0 to the states of the others. */
void clod_crew_state_tell(clod_ranks *ranks, clod_state *state);

/**
 * For the first time: walls with their shapes, poses at the last rebuild, and laws.
 *
 * @param state, laws  of rank 0; empty on other ranks, which own what they get
 * @return             false without memory on any rank, on all alike
 */
bool clod_crew_state_begin(clod_ranks *ranks, clod_state *state, clod_laws *laws,
                           clod_status *status);
