#pragma once
/**
 * @file stages.h
 * A clock behind each stage of the step.
 */

#include "step/stages.h"

/** Those of a step, and behind them the last ones of a call. */
#define BENCH_STAGES (CLOD_STAGES + CLOD_LAST_STAGES)

/** Seconds of a clock that never goes back. */
double bench_now(void);

/**
 * Advance a state with a clock of thread 0 behind each stage and its barrier. One step at a time
 * in a process.
 *
 * @param seconds  [out] of thread 0 in each stage, over all steps, waiting for others included
 * @return         false when the step failed
 */
bool bench_stages_advance(clod_step *step, int64_t steps, double seconds[BENCH_STAGES],
                          clod_status *status);

/** Name of a stage in its table. */
const char *bench_stage_name(int stage);
