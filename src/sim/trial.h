#pragma once
/**
 * @file trial.h
 * Try whether a run can begin: before the results of an earlier one are removed for it, and for
 * `clod check`.
 */

#include "clod/run.h"

/**
 * Do for every seed what a run does at its start, and throw it away: build the state, begin the
 * procedure, compute the first forces, and advance by some steps.
 *
 * @param options  threads and instruction set
 * @param steps    after the first forces; a run that ends before is done then
 * Errors  what would end the run by then: grains that do not fit, are outside the domain or
 *         overlap, a time step that is too long, a wrong grain file, walls that cannot be
 *         built, periods that are too short.
 * Threads pure.   Test  tests/cli/test_folder.py, tests/cli/test_check_as_run.py
 */
bool clod_trial_run(const clod_case *from, const clod_run_options *options, int64_t steps,
                    clod_status *status);
