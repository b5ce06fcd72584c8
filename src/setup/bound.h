#pragma once
/**
 * @file bound.h
 * The critical time step of the grains and walls of a state, and of those that are to come.
 */

#include "clod/case.h"
#include "measure/survey.h"
#include "setup/tally.h"

/** What the critical time step follows from, for some grains and walls. */
typedef struct clod_setup_bound {
    clod_timestep_sizes *sizes; ///< [materials] of the grains; owned, as the next
    bool *is_wall;              ///< [materials] of which there are walls
    double stress;              ///< Pa that grains carry
    double speed;               ///< m/s at which grains meet
} clod_setup_bound;

/**
 * Of the grains and walls of a state; stress and speed as for clod_setup_timestep.
 *
 * @param self  [out] clod_setup_bound_fini, also after a failure
 * Errors  CLOD_FAILED without memory.   Threads  pure.   Test  tests/sim/test_sim_change.c
 */
bool clod_setup_bound_init(clod_setup_bound *self, const clod_case *from,
                           const clod_state *state, clod_status *status);

/** The same of grains that have been added up. */
bool clod_setup_bound_init_of(clod_setup_bound *self, const clod_case *from,
                              const clod_setup_tally *tally, const clod_state *state,
                              clod_status *status);

/** Time step of the case with the grains and walls that there are by now. */
clod_timestep clod_setup_bound_timestep(const clod_setup_bound *self, const clod_case *from);

void clod_setup_bound_fini(clod_setup_bound *self);

/**
 * Whether the time step of a state is stable with its grains and walls.
 *
 * @param what  is new, for the message: "these radii"
 * Errors  CLOD_USAGE with the critical step, CLOD_FAILED without memory.   Threads  pure.
 * Test    tests/sim/test_sim_radii.c
 */
bool clod_setup_bound_fits(const clod_case *from, const clod_state *state, const char *what,
                           clod_status *status);

/**
 * Whether the case has laws for all that grains from its inlets can meet, and the time step is
 * stable with them and the grains that there are.
 *
 * Errors  CLOD_USAGE, CLOD_FAILED without memory.   Threads  pure.
 * Test    tests/setup/test_setup_bound.c
 */
bool clod_setup_bound_streams(const clod_case *from, const clod_survey *survey,
                              clod_status *status);

/**
 * Whether the case has laws for all that grains and walls in state->changes can meet, and the
 * time step is stable with them: clod_step_options.accepts. Loaded walls in the queue get their
 * damping.
 *
 * @param from  clod_case of the state
 * Errors  CLOD_USAGE, CLOD_FAILED without memory.   Threads  pure.
 * Test    tests/sim/test_sim_change.c, tests/setup/test_setup_bound.c
 */
bool clod_setup_bound_accepts(const void *from, const clod_state *state, clod_status *status);
