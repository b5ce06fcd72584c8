#pragma once
/**
 * @file belt_work.h
 * Work that a wall does on the grains, taken in portions: gauges and belts share it. The walls'
 * sums begin anew after every row of the series; who takes portions says when that is.
 */

#include "state/state.h"

/** What has been taken of a wall's work; plain data, part of the checkpoint. */
typedef struct clod_belt_work {
    double seen;  ///< J since the last row that have been taken
    double since; ///< s, time up to which they are
} clod_belt_work;

/** Work and the time in which it was done. */
typedef struct clod_belt_portion {
    double work; ///< J
    double time; ///< s
} clod_belt_portion;

/** Take what a wall has done since the last time. Threads: one per wall. */
static inline clod_belt_portion clod_belt_work_take(clod_belt_work *self, const clod_wall *wall,
                                                    const clod_state *state)
{
    const double work = wall->sum_power * state->dt;
    const clod_belt_portion portion = {work - self->seen, state->time - self->since};
    *self = (clod_belt_work){work, state->time};
    return portion;
}
