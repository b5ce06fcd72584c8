#include "stages.h"

#include <time.h>

double bench_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double spent[BENCH_STAGES]; // by thread 0
static double before;

static void take_time(int part, int stage)
{
    if (part == 0) {
        const double now = bench_now();
        spent[stage] += now - before;
        before = now;
    }
}

bool bench_stages_advance(clod_step *step, int64_t steps, double seconds[BENCH_STAGES],
                          clod_status *status)
{
    for (int k = 0; k < BENCH_STAGES; k++) {
        spent[k] = 0.0;
    }
    step->after_stage = take_time;
    before = bench_now();
    const bool good = clod_step_advance(step, steps, status);
    step->after_stage = NULL;
    for (int k = 0; k < BENCH_STAGES; k++) {
        seconds[k] = spent[k];
    }
    return good;
}

const char *bench_stage_name(int stage)
{
    return stage < CLOD_STAGES ? CLOD_STAGE[stage].name
                               : CLOD_LAST_STAGE[stage - CLOD_STAGES].name;
}
