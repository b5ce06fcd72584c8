#pragma once
/**
 * @file contact_force.h
 * The force of one contact, told again from the state of the moment: positions, velocities,
 * history, and walls as they are now. Nothing that a step has left behind is read, so one process
 * and several ranks tell the same. Springs give what they gave in the last step; dash-pots
 * count with the velocities of the moment: half a kick later than those that the step used, and
 * at a wall with a load those that its servo has for the next step.
 *
 * Threads  pure.   Test  tests/step/test_contact_force.c
 */

#include "law/law.h"
#include "state/contact_source.h"
#include "step/step.h"

/**
 * The law of a contact with today's adhesion; borrowed.
 *
 * @param r_star  [out] m
 * Errors  none.
 */
const clod_law *clod_step_law_of(const clod_step *self, const clod_contact *contact,
                                 double *r_star);

/** @param step  a clod_step.   See clod_contact_source. */
clod_contact_force clod_step_force_of(const void *step, const clod_contact *contact);

/** The same of what a contact of two grains gains. */
clod_contact_gain clod_step_gain_of(const void *step, const clod_contact *contact);

/** The same of the wall's material at a contact with it. */
void clod_step_carrier_of(const void *step, const clod_contact *contact, double velocity[3]);
