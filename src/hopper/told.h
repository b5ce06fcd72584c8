#pragma once
/**
 * @file told.h
 * Which numbers have no interval, since nothing tells how far the wall, or a limit that is given, is off.
 */

#include "hopper/result.h"

/**
 * Whether samples tell how sure a hopper is. They do not where the half angle is given and the wall, or the limit that is
 * given, has no error: with a rougher wall the outlet is wider, or the solid does not slide.
 */
bool clod_told_is_sure(const clod_hopper *self, const clod_hopper_found *found);

/** No interval. */
void clod_told_no_interval(clod_hopper_value *value);

/**
 * Take back what the samples say of a shape although nothing tells it: intervals, and of a hopper that is not sure shares,
 * quantiles and causes, which become NAN.
 *
 * Errors  none.   Test  tests/hopper/test_measured.py, test_untold.py
 */
void clod_told_forget(const clod_hopper *self, clod_hopper_found *found);
