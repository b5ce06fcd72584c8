#pragma once
/**
 * @file stages.h
 * A clock behind each stage of the step.
 */

#include "step/stages.h"

/** Seconds of a clock that never goes back. */
double bench_now(void);

/**
 * Advance a state with a clock of thread 0 behind each stage and its barrier. One step at a time
 * in a process.
 *
 * @param seconds  [out] of thread 0 in each stage, over all steps, waiting for others included
 * @return         false when the step failed
 */
bool bench_stages_advance(clod_step *step, int64_t steps, double seconds[CLOD_STAGES],
                          clod_status *status);
