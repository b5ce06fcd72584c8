#include "sim/trial.h"

#include "law/law.h"
#include "setup/begin.h"
#include "sim/free_stages.h"
#include "step/step.h"
#include "tester/ring_shear.h"
#include "tester/uniaxial.h"

/** A run of one seed: its procedure is that of a free run or of the case's tester. */
typedef struct trial {
    const clod_case *from;
    clod_state state;
    clod_laws laws;
    clod_step step;
    clod_free_stages stages;
    clod_ring_shear shear;
    clod_uniaxial uniaxial;
} trial;

static void begin(trial *self)
{
    if (clod_case_shear(self->from) != NULL) {
        clod_ring_shear_begin(&self->shear, self->from, &self->state);
    } else if (self->from->uniaxial.present) {
        clod_uniaxial_begin(&self->uniaxial, self->from, &self->state);
    } else {
        clod_free_stages_begin(&self->stages, self->from, &self->state);
    }
}

/** Steps until the procedure looks. */
static int64_t plan(const trial *self)
{
    if (clod_case_shear(self->from) != NULL) {
        return clod_ring_shear_plan(&self->shear, &self->state);
    }
    return self->from->uniaxial.present
               ? clod_uniaxial_plan(&self->uniaxial, &self->state)
               : clod_free_stages_plan(&self->stages, self->from, &self->state);
}

/** The procedure's look; *finished when it was the last. */
static bool look(trial *self, bool *finished, clod_status *status)
{
    char text[512];
    bool trouble = false;
    if (clod_case_shear(self->from) != NULL) {
        double row[CLOD_RING_SHEAR_COLUMNS];
        *finished = clod_ring_shear_sample(&self->shear, &self->state, row);
        trouble = clod_ring_shear_trouble(&self->shear, text, sizeof text);
    } else if (self->from->uniaxial.present) {
        double row[CLOD_UNIAXIAL_COLUMNS];
        *finished = clod_uniaxial_sample(&self->uniaxial, &self->state, row);
        trouble = clod_uniaxial_trouble(&self->uniaxial, text, sizeof text);
    } else {
        *finished = clod_free_stages_look(&self->stages, self->from, &self->state) &&
                    clod_free_stages_next(&self->stages, self->from, &self->state);
    }
    clod_laws_set_adhesion(&self->laws, self->state.adhesion);
    return !trouble || clod_status_fail(status, CLOD_FAILED, "step %lld: %s",
                                        (long long)self->state.step, text);
}

static bool advance(trial *self, int64_t steps, clod_status *status)
{
    bool finished = false;
    while (!finished && self->state.step < steps) {
        const int64_t left = steps - self->state.step;
        const int64_t planned = plan(self);
        if (!clod_step_advance(&self->step, planned < left ? planned : left, status) ||
            (planned <= left && !look(self, &finished, status))) {
            return false;
        }
    }
    return true;
}

static bool try_seed(const clod_case *from, int64_t seed, const clod_run_options *options,
                     int64_t steps, clod_status *status)
{
    trial self = {.from = from};
    bool good = clod_begin_state(from, seed, &self.state, status) &&
                clod_laws_init(&self.laws, from, status);
    if (good) {
        const clod_step_options how = {.threads = options->threads,
                                       .simd = options->simd,
                                       .overlap_limit = from->time.overlap_limit};
        begin(&self);
        clod_laws_set_adhesion(&self.laws, self.state.adhesion);
        good = clod_step_init(&self.step, &self.state, &self.laws, &how, status) &&
               advance(&self, steps, status);
    }
    clod_step_fini(&self.step);
    clod_laws_fini(&self.laws);
    clod_state_fini(&self.state);
    return good;
}

bool clod_trial_run(const clod_case *from, const clod_run_options *options, int64_t steps,
                    clod_status *status)
{
    const clod_case_programme *shear = clod_case_shear(from);
    const int64_t seeds = shear != NULL ? shear->seeds : 1;
    bool good = true;
    for (int64_t s = 0; good && s < seeds; s++) {
        good = try_seed(from, from->seed + s, options, steps, status);
    }
    return good;
}
