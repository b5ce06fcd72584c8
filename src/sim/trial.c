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

/** Trouble that a procedure tells of ends the trial. */
static bool go_on(const trial *self, bool trouble, const char *text, clod_status *status)
{
    return !trouble || clod_status_fail(status, CLOD_FAILED, "step %lld: %s",
                                        (long long)self->state.step, text);
}

// ---- free runs

static void free_begin(trial *self)
{
    clod_free_stages_begin(&self->stages, self->from, &self->state);
}

static int64_t free_plan(const trial *self)
{
    return clod_free_stages_plan(&self->stages, self->from, &self->state);
}

static bool free_look(trial *self, bool *finished, clod_status *status)
{
    (void)status;
    *finished = clod_free_stages_look(&self->stages, self->from, &self->state) &&
                clod_free_stages_next(&self->stages, self->from, &self->state);
    return true;
}

// ---- shear tests

static void shear_begin(trial *self)
{
    clod_ring_shear_begin(&self->shear, self->from, &self->state);
}

static int64_t shear_plan(const trial *self)
{
    return clod_ring_shear_plan(&self->shear, &self->state);
}

static bool shear_look(trial *self, bool *finished, clod_status *status)
{
    char text[512];
    double row[CLOD_RING_SHEAR_COLUMNS];
    *finished = clod_ring_shear_sample(&self->shear, &self->state, row);
    return go_on(self, clod_ring_shear_trouble(&self->shear, text, sizeof text), text, status);
}

// ---- uniaxial tests

static void uniaxial_begin(trial *self)
{
    clod_uniaxial_begin(&self->uniaxial, self->from, &self->state);
}

static int64_t uniaxial_plan(const trial *self)
{
    return clod_uniaxial_plan(&self->uniaxial, &self->state);
}

static bool uniaxial_look(trial *self, bool *finished, clod_status *status)
{
    char text[512];
    double row[CLOD_UNIAXIAL_COLUMNS];
    *finished = clod_uniaxial_sample(&self->uniaxial, &self->state, row);
    return go_on(self, clod_uniaxial_trouble(&self->uniaxial, text, sizeof text), text, status);
}

/** The procedure of each kind of case. */
typedef struct procedure {
    void (*begin)(trial *self);
    int64_t (*plan)(const trial *self); ///< steps until it looks
    /** Its look; *finished when it was the last. */
    bool (*look)(trial *self, bool *finished, clod_status *status);
} procedure;

static const procedure PROCEDURE[CLOD_CASE_KINDS] = {
    [CLOD_CASE_FREE] = {free_begin, free_plan, free_look},
    [CLOD_CASE_RING_SHEAR] = {shear_begin, shear_plan, shear_look},
    [CLOD_CASE_JENIKE] = {shear_begin, shear_plan, shear_look},
    [CLOD_CASE_UNIAXIAL] = {uniaxial_begin, uniaxial_plan, uniaxial_look},
};

static const procedure *procedure_of(const trial *self)
{
    return &PROCEDURE[clod_case_kind_of(self->from)];
}

static bool look(trial *self, bool *finished, clod_status *status)
{
    const bool good = procedure_of(self)->look(self, finished, status);
    clod_laws_set_adhesion(&self->laws, self->state.adhesion);
    return good;
}

static bool advance(trial *self, int64_t steps, clod_status *status)
{
    bool finished = false;
    while (!finished && self->state.step < steps) {
        const int64_t left = steps - self->state.step;
        const int64_t planned = procedure_of(self)->plan(self);
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
        procedure_of(&self)->begin(&self);
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
