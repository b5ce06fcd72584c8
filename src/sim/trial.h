#pragma once
/**
 * @file trial.h
 * Try whether a run can begin, before the results of an earlier one are removed for it.
 */

#include "clod/run.h"

/**
 * Build the state of every seed up to the first forces, and throw it away.
 *
 * Errors  what would end the run before its first step: grains that do not fit, a time step
 *         that is too long, a wrong grain file, walls that cannot be built.
 * Threads pure.   Test  tests/cli/test_folder.py
 */
bool clod_trial_run(const clod_case *from, const clod_run_options *options,
                    clod_status *status);
