#pragma once
/**
 * @file measured_header.h
 * What the header of a measured table says beyond the kinds that `clod locus` evaluates.
 */

#include <stdbool.h>
#include <stddef.h>

/** Whether a table is of properties over sigma_1, as a flow function or bulk densities, and neither of
 *  shear points nor of a wall yield locus. Threads  pure.   Test  tests/calibrate/test_plan_curves.c */
bool clod_measured_over_sigma_1(const char *text, size_t length);
