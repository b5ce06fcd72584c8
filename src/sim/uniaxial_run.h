#pragma once
/**
 * @file uniaxial_run.h
 * A whole uniaxial test: the filled mould, then all consolidation stresses from it, side by
 * side where cores allow; then the flow function.
 */

#include "sim/parts.h"
#include "tester/uniaxial.h"

/** Run the test; the report is the result table with the warning box. */
bool clod_uniaxial_run(const clod_sim *sim, char **report, clod_status *status);
