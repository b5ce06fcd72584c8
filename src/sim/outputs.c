#include "sim/outputs.h"

#include <math.h>
#include <stdio.h>

#define FAR_AWAY 9e18 ///< a step that no run reaches, within 64 bits

static bool is_short(double interval, double dt)
{
    return interval > 0.0 && interval < dt;
}

bool clod_outputs_say_short(const clod_case *from, double dt, char *text, size_t size)
{
    const double pictures = from->output.snapshot_interval;
    const double rows = from->output.series_interval;
    const bool many = is_short(pictures, dt);
    const bool any = many || (clod_case_tester(from) == NULL && is_short(rows, dt));
    if (any) {
        snprintf(text, size,
                 "output.%s (%.4g s) is shorter than a time step (%.4g s): every step is "
                 "written. Make it as long as a step at least",
                 many ? "snapshot_interval" : "series_interval", many ? pictures : rows, dt);
    }
    return any;
}

/** Steps between two outputs, seldom a whole number. */
static double pace_of(double interval, double dt)
{
    return fmax(interval / dt, 1.0);
}

/** Step of output number k: rising with k, as the pace is 1 at least. */
static int64_t step_of(double pace, double k)
{
    return (int64_t)fmin(round(k * pace), FAR_AWAY);
}

/** Number of the last output that is due at `step` or before; 0 before the first. */
static double last_until(double pace, int64_t step)
{
    double k = fmax(round((double)step / pace) - 1.0, 0.0);
    while (step_of(pace, k + 1.0) <= step) {
        k += 1.0;
    }
    return k;
}

int64_t clod_outputs_next(double interval, double dt, int64_t step)
{
    const double pace = pace_of(interval, dt);
    return step_of(pace, last_until(pace, step) + 1.0);
}

bool clod_outputs_are_due(double interval, double dt, int64_t step)
{
    return interval > 0.0 && step > 0 && clod_outputs_next(interval, dt, step - 1) == step;
}

int64_t clod_outputs_count(double interval, double dt, int64_t step)
{
    return interval > 0.0 ? (int64_t)last_until(pace_of(interval, dt), step) : 0;
}

int64_t clod_outputs_stage_steps(const clod_case *from, size_t stage, double dt)
{
    return (int64_t)fmax(1.0, round(from->stages[stage].duration / dt));
}

clod_outputs clod_outputs_of(const clod_case *from, double dt)
{
    const double series = from->output.series_interval;
    const double pictures = from->output.snapshot_interval;
    clod_outputs all = {0};
    for (size_t s = 0; s < from->stage_count; s++) {
        const int64_t steps = clod_outputs_stage_steps(from, s, dt);
        all.steps += steps;
        // the end of a stage has a row and a picture of its own, unless one is due there anyway
        all.rows += clod_outputs_count(series, dt, steps - 1) + 1;
        all.snapshots += clod_outputs_are_due(pictures, dt, all.steps) ? 0 : 1;
    }
    all.snapshots += clod_outputs_count(pictures, dt, all.steps);
    return all;
}
