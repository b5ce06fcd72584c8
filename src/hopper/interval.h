#pragma once
/**
 * @file interval.h
 * Errors of the measured values carried to the results: every value is drawn from a normal
 * distribution about what was measured, many times, and each time a hopper is designed.
 */

#include "hopper/result.h"

/** The numbers of one shape, as they count in quantiles. */
void clod_interval_numbers(const clod_solid *solid, const clod_hopper_found *found,
                           clod_hopper_outcome *outcome, double number[CLOD_HOPPER_NUMBERS]);

/**
 * Fill in the intervals and shares of a design whose values are known.
 *
 * Errors  CLOD_FAILED: memory.   Threads  uses all processors; the same result on any number.
 * Test    tests/hopper/test_interval.c
 */
bool clod_interval_fill(clod_hopper *self, clod_status *status);

/**
 * Design from each specimen of the shear tests alone, where two or more are in all yield loci.
 *
 * Errors  CLOD_FAILED: memory.   Test  tests/hopper/test_measured.py
 */
bool clod_interval_specimens(clod_hopper *self, clod_status *status);
