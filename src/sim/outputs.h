#pragma once
/**
 * @file outputs.h
 * When a run writes: intervals of simulated time, counted in steps. The run asks for the next
 * step of each, `clod check` for how many there will be: both with the functions here.
 *
 * Output number k of an interval is due at the step that is nearest to k times the interval, so
 * nothing drifts and nothing has to be remembered. An interval shorter than a step is a step.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/case.h"

/**
 * Say that an interval of the case is shorter than the step, into `text`.
 *
 * @return  false when none is; a tester's series has none
 * Errors  none.   Threads  pure.   Test  tests/sim/test_outputs.c
 */
bool clod_outputs_say_short(const clod_case *from, double dt, char *text, size_t size);

/**
 * The first step after `step` at which an output is due.
 *
 * @param interval  s, above 0
 * @param dt        time step [s]
 * @param step      0 or more, from where the interval is counted
 * Errors  none.   Threads  pure.   Test  tests/sim/test_outputs.c
 */
int64_t clod_outputs_next(double interval, double dt, int64_t step);

/** Whether an output is due at a step; never at step 0, and never with interval 0. */
bool clod_outputs_are_due(double interval, double dt, int64_t step);

/** Outputs that are due after step 0, up to and with `step`; 0 with interval 0. */
int64_t clod_outputs_count(double interval, double dt, int64_t step);

/** Steps of a stage of a free run that lasts its whole duration. */
int64_t clod_outputs_stage_steps(const clod_case *from, size_t stage, double dt);

/** What a free run leaves when every stage lasts its whole duration. */
typedef struct clod_outputs {
    int64_t steps;
    int64_t rows;      ///< of the series
    int64_t snapshots; ///< with the one at the end of each stage
} clod_outputs;

/**
 * Count the outputs of a free run that begins at step 0.
 *
 * Errors  none.   Threads  pure.   Test  tests/sim/test_outputs.c, tests/cli/test_outputs.py
 */
clod_outputs clod_outputs_of(const clod_case *from, double dt);
