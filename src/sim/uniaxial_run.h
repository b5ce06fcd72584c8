#pragma once
/**
 * @file uniaxial_run.h
 * A whole uniaxial test: the filled mould, then all consolidation stresses from it, side by
 * side where cores allow; then the flow function.
 */

#include "sim/parts.h"
#include "tester/uniaxial.h"

/** Its parts. */
extern const clod_parts_tester CLOD_UNIAXIAL_TESTER;

/** Run the test; the report is the result table with the warning box. */
bool clod_uniaxial_run(const clod_job_shared *sim, char **report, clod_status *status);

/** Whether its preparation can be taken over from the run that it begins from, before anything
 *  is written. Errors  see clod_job_try_origin.   Test  tests/restart/test_from.py */
bool clod_uniaxial_try_origin(const clod_job_shared *sim, clod_status *status);
