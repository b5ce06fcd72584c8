#pragma once
/**
 * @file wall_shear_run.h
 * A whole wall friction test: the filled cells of all seeds, then the shear of each, side by
 * side where cores allow; then the wall yield locus.
 */

#include "sim/parts.h"
#include "tester/wall_shear.h"

/** Its parts. */
extern const clod_parts_tester CLOD_WALL_SHEAR_TESTER;

/** Run the test; the report is the result table with the warning box. */
bool clod_wall_shear_run(const clod_job_shared *sim, char **report, clod_status *status);

/** Whether its preparation can be taken over from the run that it begins from, before anything
 *  is written. Errors  see clod_job_try_origin.   Test  tests/restart/test_from.py */
bool clod_wall_shear_try_origin(const clod_job_shared *sim, clod_status *status);
