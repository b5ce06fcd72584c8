#pragma once
/**
 * @file state.h
 * A whole case made into a state that is ready for the first step.
 */

#include "clod/case.h"
#include "setup/pieces.h"
#include "setup/timestep.h"
#include "state/state.h"

/**
 * Build the state of a free run: walls, domain, grains, gravity, time step, and the k_adh of
 * the first stage. Loaded walls get their damping from the bed's estimated stiffness.
 *
 * @param seed   of sizes and positions
 * @param state  [out] owned by the caller (clod_state_fini), also after a failure
 * Errors  CLOD_USAGE for a case or a file that cannot be built, CLOD_FAILED without memory.
 * Threads pure.   Test  tests/setup/test_setup_state.c
 */
bool clod_setup_state(const clod_case *from, int64_t seed, clod_state *state,
                      clod_status *status);

/**
 * The same state, its grains given away as they are made.
 *
 * @param taker  NULL: the state keeps them; only of cases with clod_setup_grains_in_pieces
 * @param bed    [out] of all grains
 */
bool clod_setup_state_give(const clod_case *from, int64_t seed, const clod_setup_taker *taker,
                           clod_state *state, clod_setup_bed *bed, clod_status *status);

/**
 * Time step of a case whose grains and walls are in a state, with all numbers behind it.
 *
 * The load that sets the overlap is design_stress; else the largest stress of the tester;
 * else the larger of what loads and weight press on the bed, and an impact with the
 * fastest grain's speed plus a fall through the height of grains and walls.
 *
 * Errors  CLOD_FAILED without memory.   Threads  pure.
 */
bool clod_setup_timestep(const clod_case *from, const clod_state *state, clod_timestep *result,
                         clod_status *status);

/** Damping of all loaded walls from their fraction of critical and the bed's stiffness; where
 *  there are no grains they keep what they have. */
void clod_setup_damping(clod_state *state, const clod_timestep *timestep);

/** The same on a bed that is not in the state. */
void clod_setup_damping_on(clod_state *state, const clod_setup_bed *bed,
                           const clod_timestep *timestep);
