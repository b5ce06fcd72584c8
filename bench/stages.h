#pragma once
/**
 * @file stages.h
 * The stages of the step one by one, with a clock around each.
 */

#include "step/stages.h"

/** Seconds of a clock that never goes back. */
double bench_now(void);

/**
 * Advance a state of one thread that clod_step_advance has advanced before.
 *
 * @param seconds  [out] spent in each stage, over all steps
 * @return         false when the step failed
 */
bool bench_stages_advance(clod_step *step, int64_t steps, double seconds[CLOD_STAGES],
                          clod_status *status);
