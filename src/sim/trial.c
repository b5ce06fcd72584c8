#include "sim/trial.h"

#include "law/law.h"
#include "setup/begin.h"
#include "step/step.h"

static bool try_first_forces(const clod_case *from, const clod_run_options *options,
                             clod_state *state, clod_status *status)
{
    clod_laws laws = {0};
    clod_step step = {0};
    bool good = clod_laws_init(&laws, from, status);
    if (good) {
        const clod_step_options how = {.threads = options->threads, .simd = options->simd};
        clod_laws_set_adhesion(&laws, state->adhesion);
        good = clod_step_init(&step, state, &laws, &how, status);
    }
    clod_step_fini(&step);
    clod_laws_fini(&laws);
    return good;
}

bool clod_trial_run(const clod_case *from, const clod_run_options *options, clod_status *status)
{
    const clod_case_programme *shear = clod_case_shear(from);
    const int64_t seeds = shear != NULL ? shear->seeds : 1;
    bool good = true;
    for (int64_t s = 0; good && s < seeds; s++) {
        clod_state state;
        good = clod_begin_state(from, from->seed + s, &state, status) &&
               try_first_forces(from, options, &state, status);
        clod_state_fini(&state);
    }
    return good;
}
