#pragma once
/**
 * @file arrival.h
 * The bed as it will be when what is asked for in state->changes has come and gone: what a case
 * that begins at this moment would know of it.
 */

#include "clod/case.h"
#include "setup/timestep.h"
#include "state/state.h"

/** Whether a wall with a load comes: only its damping depends on the whole bed. */
bool clod_setup_arrival_loads(const clod_changes *queue);

/**
 * Grains by their ids and walls, those that go left out, those that come behind the others.
 *
 * @param after  [out] clod_setup_arrival_fini, also after a failure; shapes of walls are borrowed
 * @param state  its queue is sorted (clod_requests_check)
 * Errors  CLOD_FAILED without memory.   Threads  pure.   Test  tests/sim/test_sim_wall_loads.c
 */
bool clod_setup_arrival_init(clod_state *after, const clod_case *from, const clod_state *state,
                             clod_status *status);

/**
 * Give walls that come their damping, as clod_setup_damping.
 *
 * @param after  of this queue; the damping of its loaded walls is changed
 */
void clod_setup_arrival_damp(clod_state *after, const clod_timestep *timestep,
                             const clod_changes *queue);

void clod_setup_arrival_fini(clod_state *after);
