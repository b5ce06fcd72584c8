#pragma once
/**
 * @file critical.h
 * The critical state of a hopper: where the flow function meets the flow factor of that state; for
 * design.c and critical.c.
 */

#include "hopper/design.h"

#define CLOD_CRITICAL_ROUNDS 60
#define CLOD_CRITICAL_CLOSE                                                                    \
    10.0 ///< relative change of sigma_1 at which the state is found, in tolerances

/** The half angle of a design [rad]: the limit less the margin, which counts as 0.05 deg at least. */
double clod_critical_below(double limit, double margin);

/** Largest half angle of mass flow in a cone for a state; 0: none. */
double clod_critical_limit(const clod_solid_state *state, double tolerance);

/**
 * State, half angle, H and flow factor at one stress; false: funnel flow.
 *
 * @param self  [in,out] the field's axis in it tells where to look first; 0: not known
 */
bool clod_critical_shape(const clod_solid *solid, const clod_hopper_wish *wish, double sigma_1,
                         clod_hopper_design *self);

/** The outlet at whose wall there is the stress of a state [m]. */
double clod_critical_outlet(const clod_hopper_design *at);

/** The stress at which a search begins [Pa]. */
double clod_critical_first(const clod_solid *solid, const clod_hopper_wish *wish);

/**
 * The critical state below the half angle of the wish, or below that of the state itself: the largest stress
 * at which the flow function comes below the flow factor.
 *
 * Errors  none.   Threads  pure.   Source  docs/theory/hopper.md.   Test  tests/hopper/test_design.c
 */
clod_hopper_design clod_critical_settle(const clod_solid *solid, const clod_hopper_wish *wish);

/** The same, quicker: seldom there is another one at a larger stress. */
clod_hopper_design clod_critical_guess(const clod_solid *solid, const clod_hopper_wish *wish);
