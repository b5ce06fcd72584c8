#include "verify/bed.h"

#include <string.h>

#include "measure/contacts.h"
#include "setup/state.h"
#include "verify/case_file.h"

/** Steps until the next look, row or insertion. */
static int64_t plan(const clod_verify_bed *self)
{
    const int64_t stage = clod_free_stages_plan(&self->stages, self->from, &self->state);
    const int64_t inlet =
        CLOD_MEASURE_INLETS.plan(&self->inlets, self->from, &self->state, NULL);
    return stage < inlet ? stage : inlet;
}

static bool run_stages(clod_verify_bed *self, clod_verify_bed_look look, void *context,
                       clod_status *status)
{
    clod_free_stages_begin(&self->stages, self->from, &self->state);
    const clod_free_start bed = clod_free_start_of(&self->state);
    CLOD_MEASURE_INLETS.begin(&self->inlets, self->from, &self->state, &bed);
    const clod_survey survey = clod_survey_of(&self->state, NULL);
    const clod_free_moment now = {.from = self->from, .state = &self->state, .survey = &survey};
    bool ok = look(context, self, status);
    for (bool finished = false; ok && !finished;) {
        ok = CLOD_MEASURE_INLETS.act(&self->inlets, &now, status) &&
             clod_step_advance(&self->step, plan(self), status);
        if (!ok || !clod_free_stages_look(&self->stages, self->from, &self->state, &survey)) {
            continue;
        }
        ok = look(context, self, status);
        finished = ok && clod_free_stages_next(&self->stages, self->from, &self->state);
        clod_laws_set_adhesion(&self->laws, self->state.adhesion);
    }
    return ok;
}

static bool run_loaded(clod_verify_bed *self, clod_verify_bed_look look, void *context,
                       clod_status *status)
{
    const clod_step_options options = {.overlap_limit = self->from->time.overlap_limit};
    bool ok = clod_laws_init(&self->laws, self->from, status) &&
              clod_setup_state(self->from, self->from->seed, &self->state, status);
    if (ok) {
        clod_laws_set_adhesion(&self->laws, self->state.adhesion);
        ok = clod_step_init(&self->step, &self->state, &self->laws, &options, status) &&
             run_stages(self, look, context, status);
        clod_step_fini(&self->step);
    }
    clod_state_fini(&self->state);
    clod_laws_fini(&self->laws);
    return ok;
}

bool clod_verify_bed_run(const clod_verify_bench *bench, const char *name, const char *text,
                         clod_verify_bed_look look, void *context, clod_status *status)
{
    char path[4096];
    clod_verify_bed self = {0};
    if (!clod_verify_case_file(bench->directory, name, text, path, status)) {
        return false;
    }
    self.from = clod_case_load(path, NULL, 0, status);
    if (self.from == NULL) {
        return false;
    }
    const bool ok = run_loaded(&self, look, context, status);
    clod_case_destroy(&self.from);
    return ok;
}

bool clod_verify_bed_is_in(const clod_verify_bed *self, const char *stage)
{
    return strcmp(clod_free_stages_name(&self->stages, self->from), stage) == 0;
}

bool clod_verify_bed_overlap(clod_verify_bed *self, double *overlap, clod_status *status)
{
    if (!clod_step_export(&self->step, status)) {
        return false;
    }
    *overlap = clod_measure_contacts_of(&self->state).max_overlap;
    return true;
}
