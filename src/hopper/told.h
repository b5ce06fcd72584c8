#pragma once
/**
 * @file told.h
 * Which numbers have no interval, since nothing tells how far the flow function, the wall, or a limit that is given, is off.
 */

#include "hopper/result.h"

/** Whether something tells how far the flow function is off; if not, no outlet and no rathole has an interval. */
bool clod_told_strength(const clod_hopper *self);

/**
 * Whether samples tell how sure the wall makes a hopper. They do not where the half angle is given and the wall, or the
 * limit that is given, has no error: with a rougher wall the outlet is wider, or the solid does not slide.
 */
bool clod_told_is_sure(const clod_hopper *self, const clod_hopper_found *found);

/** No interval. */
void clod_told_no_interval(clod_hopper_value *value);

/**
 * Take back what the samples say of a shape although nothing tells it: intervals, and of a hopper that is not sure shares,
 * quantiles and causes, which become NAN. Without errors of the flow function shares of mass flow stay: the wall decides it.
 *
 * Errors  none.   Test  tests/hopper/test_measured.py, test_untold.py
 */
void clod_told_forget(const clod_hopper *self, clod_hopper_found *found);
