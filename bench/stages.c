#include "stages.h"

#include <time.h>

double bench_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

bool bench_stages_advance(clod_step *step, int64_t steps, double seconds[CLOD_STAGES],
                          clod_status *status)
{
    for (int k = 0; k < CLOD_STAGES; k++) {
        seconds[k] = 0.0;
    }
    double before = bench_now();
    for (int64_t s = 0; s < steps; s++) {
        for (int k = 0; k < CLOD_STAGES; k++) {
            CLOD_STAGE[k].run(step, 0);
            const double after = bench_now();
            seconds[k] += after - before;
            before = after;
        }
        if (step->failed || step->thread[0].excess || !step->thread[0].all_finite) {
            return clod_status_fail(status, CLOD_FAILED, "a stage failed");
        }
        step->state->step++;
    }
    clod_step_settle(step, 0);
    step->state->build_motion = step->thread[0].build_motion;
    step->state->time = (double)step->state->step * step->state->dt;
    return true;
}
