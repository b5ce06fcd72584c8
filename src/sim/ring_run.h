#pragma once
/**
 * @file ring_run.h
 * A whole shear test in a ring or a Jenike cell: for every seed the presheared specimen, then
 * all shear points from it, side by side where cores allow; then the yield locus.
 */

#include "sim/parts.h"
#include "tester/ring_shear.h"

/** Run the test; the report is the result table with the warning box. */
bool clod_ring_run(const clod_sim *sim, char **report, clod_status *status);
