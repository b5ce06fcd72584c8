#pragma once
/**
 * @file stages.h
 * The stages of the step one by one, with a clock around each.
 */

#include "step/step.h"

#define BENCH_STAGES 7

typedef struct bench_stage {
    const char *name;
    void (*run)(clod_step *self, int part);
} bench_stage;

/** The rows of STAGES in src/step/step.c; bench/test-step compares the results. */
extern const bench_stage BENCH_STAGE[BENCH_STAGES];

/** Seconds of a clock that never goes back. */
double bench_now(void);

/**
 * Advance a state of one thread that clod_step_advance has advanced before.
 *
 * @param seconds  [out] spent in each stage, over all steps
 * @return         false when the step failed
 */
bool bench_stages_advance(clod_step *step, int64_t steps, double seconds[BENCH_STAGES],
                          clod_status *status);
