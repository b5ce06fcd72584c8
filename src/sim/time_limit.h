#pragma once
/**
 * @file time_limit.h
 * A run that must end by a moment on the clock: it stops with a checkpoint before that, early
 * enough for the checkpoint to be written.
 */

#include <stdbool.h>

/** When a run must be over; all zero: it has no limit. */
typedef struct clod_time_limit {
    double begin; ///< s on the clock
    double all;   ///< s from then on; 0: no limit
} clod_time_limit;

/** What a loop took at most so far [s]. */
typedef struct clod_time_spent {
    double turn;       ///< steps and looks between two looks at the clock
    double checkpoint; ///< 0: none was written yet
} clod_time_spent;

/**
 * Whether it is time to stop: what is left is no more than twice what a turn and the checkpoints
 * took, and a fiftieth of the limit.
 *
 * @param now   s on the clock
 * @param jobs  that may write their checkpoints at the same time
 */
bool clod_time_limit_is_near(const clod_time_limit *self, const clod_time_spent *spent,
                             int jobs, double now);

/** Whether a checkpoint is due so that somebody knows what one takes: there was none in the first
 *  half of the time. */
bool clod_time_limit_asks(const clod_time_limit *self, const clod_time_spent *spent,
                          double now);
