#pragma once
/**
 * @file stability.h
 * The largest stable time step of a bed as it is now, from all its contacts together.
 *
 * A step of velocity Verlet with the dash-pots at the velocity of the half step is
 *
 *     x(t + dt) - 2 x(t) + x(t - dt) = -dt^2 K x(t) - dt C (x(t) - x(t - dt)),   M = 1.
 *
 * It is stable as long as 4 M - 2 dt C - dt^2 K has no eigenvalue below zero; for one spring with
 * damping ratio zeta that is dt = 2/omega (sqrt(1 + zeta^2) - zeta). K has the springs of all
 * contacts (k2 or what the contact unloads with, tangential, rolling), C their dash-pots; grains
 * move and turn, walls do not, and no contact slides or rolls at its limit.
 */

#include "law/law.h"
#include "state/contact_source.h"

typedef struct clod_stability {
    size_t contacts;  ///< that are closed
    double frequency; ///< rad/s, fastest without dash-pots; 0: nothing swings
    double step;      ///< s, largest stable step; infinity without contacts, 0 when not known
} clod_stability;

/**
 * Measure a bed.
 *
 * @param state     grains, walls, domain
 * @param contacts  all closed contacts of it, in their one order
 * @param laws      with today's adhesion
 * @return          step: to 1e-5, from above
 * Errors  CLOD_FAILED without memory; step is 0 when numbers of the bed are not finite.
 * Threads  one; the same bits on any number of threads of the step.
 * Source  docs/theory/stability.md.   Test  tests/setup/test_setup_stability.c
 */
bool clod_stability_measure(clod_stability *self, const clod_state *state,
                            const clod_contact_source *contacts, const clod_laws *laws,
                            clod_status *status);
