#pragma once
/**
 * @file ring_run.h
 * A whole shear test in a ring or a Jenike cell: for every seed the presheared specimen, it
 * sheared back to zero shear stress, then all shear points from there, side by side where
 * cores allow; then the yield locus.
 */

#include "sim/parts.h"
#include "tester/ring_shear.h"

/** What stands in `point` of the parts (sim/parts.h) that prepare a specimen. */
enum { CLOD_RING_PRESHEAR = -1, CLOD_RING_REVERSE = -2 };

/** Its parts. */
extern const clod_parts_tester CLOD_RING_TESTER;

/** Run the test; the report is the result table with the warning box. */
bool clod_ring_run(const clod_job_shared *sim, char **report, clod_status *status);

/** Whether its preparation can be taken over from the run that it begins from, before anything
 *  is written. Errors  see clod_job_try_origin.   Test  tests/restart/test_from.py */
bool clod_ring_try_origin(const clod_job_shared *sim, clod_status *status);
