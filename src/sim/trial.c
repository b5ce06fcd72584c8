#include "sim/trial.h"

#include "base/memory.h"
#include "law/law.h"
#include "setup/begin.h"
#include "setup/state.h"
#include "sim/deal.h"
#include "sim/testers.h"
#include "step/step.h"

/** A run of one seed: the first part of the case's procedure, without its outputs. */
typedef struct trial {
    const clod_case *from;
    const clod_procedure *procedure;
    void *data;  ///< of the procedure, owned
    double *row; ///< that nobody reads, owned
    clod_state state;
    clod_laws laws;
    clod_step step;
    bool dealt; ///< each rank has its share of the grains
    clod_crew_share share;
} trial;

/** After the planned steps: the procedure looks; *finished when that was its last time. */
static bool look(trial *self, bool *finished, clod_status *status)
{
    const clod_procedure *way = self->procedure;
    char text[512];
    const clod_survey survey = clod_survey_of(&self->state, NULL);
    const bool due =
        way->look == NULL || way->look(self->data, self->from, &self->state, &survey);
    *finished = due && way->sample(self->data, self->from, &self->state, &survey, self->row);
    clod_laws_set_adhesion(&self->laws, self->state.adhesion);
    return way->trouble == NULL || !way->trouble(self->data, text, sizeof text) ||
           clod_status_fail(status, CLOD_FAILED, "step %lld: %s", (long long)self->state.step,
                            text);
}

static bool advance(trial *self, int64_t steps, clod_status *status)
{
    bool finished = false;
    while (!finished && self->state.step < steps) {
        const int64_t left = steps - self->state.step;
        const int64_t planned = self->procedure->plan(self->data, self->from, &self->state);
        if (!clod_step_advance(&self->step, planned < left ? planned : left, status) ||
            (planned <= left && !look(self, &finished, status))) {
            return false;
        }
    }
    return true;
}

/** The state before the first step, as a run makes it. */
static bool make_state(trial *self, int64_t seed, clod_ranks *ranks, clod_status *status)
{
    if (clod_case_kind_of(self->from) != CLOD_CASE_FREE) {
        return clod_begin_state(self->from, seed, &self->state, status);
    }
    clod_deal deal;
    clod_setup_bed bed;
    const clod_setup_taker *taker = clod_deal_begin(&deal, ranks, self->from);
    self->dealt = taker != NULL;
    const bool good =
        clod_setup_state_give(self->from, seed, taker, &self->state, &bed, status);
    clod_deal_fini(&deal);
    return good;
}

/** That state, and the procedure that begins with it. */
static bool make(trial *self, int64_t seed, clod_ranks *ranks, clod_status *status)
{
    const clod_parts_tester *first = clod_testers_of(self->from)->first;
    self->procedure = &first->procedure;
    self->data = clod_memory_alloc(1, self->procedure->size);
    self->row = clod_memory_alloc(self->procedure->column_count + 1, sizeof *self->row);
    if (self->data == NULL || self->row == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory to try the first steps");
    }
    if (!make_state(self, seed, ranks, status) ||
        !clod_laws_init(&self->laws, self->from, status)) {
        return false;
    }
    const clod_part part = {.test = self->data, .seed = seed, .point = -1};
    first->begin(self->from, &part, &self->state);
    clod_laws_set_adhesion(&self->laws, self->state.adhesion);
    return true;
}

static bool try_seed(const clod_case *from, int64_t seed, const clod_run_options *options,
                     int64_t steps, clod_status *status)
{
    clod_step_options how = {.threads = options->threads,
                             .simd = options->simd,
                             .ranks = options->ranks,
                             .overlap_limit = from->time.overlap_limit};
    trial self = {.from = from};
    bool good = make(&self, seed, options->ranks, status);
    how.dealt = self.dealt ? &self.share : NULL;
    good = good && clod_step_init(&self.step, &self.state, &self.laws, &how, status) &&
           advance(&self, steps, status);
    clod_step_fini(&self.step);
    clod_laws_fini(&self.laws);
    clod_state_fini(&self.state);
    clod_crew_share_fini(&self.share);
    clod_memory_free(self.row);
    clod_memory_free(self.data);
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
