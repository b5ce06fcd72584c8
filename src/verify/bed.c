#include "verify/bed.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "measure/contacts.h"
#include "setup/state.h"

static bool make_folder(const char *path, clod_status *status)
{
    return mkdir(path, 0777) == 0 || errno == EEXIST ||
           clod_status_fail(status, CLOD_FAILED, "%s: cannot be made: %s", path,
                            strerror(errno));
}

static bool write_text(const char *path, const char *text, clod_status *status)
{
    FILE *out = fopen(path, "w");
    bool written = out != NULL && fputs(text, out) >= 0;
    if (out != NULL) {
        written = fclose(out) == 0 && written;
    }
    return written || clod_status_fail(status, CLOD_FAILED, "%s: cannot be written: %s", path,
                                       strerror(errno));
}

static bool write_case(const char *directory, const char *name, const char *text,
                       char path[4096], clod_status *status)
{
    char folder[3072];
    snprintf(folder, sizeof folder, "%s/cases", directory);
    if (!make_folder(folder, status)) {
        return false;
    }
    snprintf(folder, sizeof folder, "%s/cases/%s", directory, name);
    snprintf(path, 4096, "%s/case.yaml", folder);
    return make_folder(folder, status) && write_text(path, text, status);
}

static bool run_stages(clod_verify_bed *self, clod_verify_bed_look look, void *context,
                       clod_status *status)
{
    clod_free_stages_begin(&self->stages, self->from, &self->state);
    bool ok = look(context, self, status);
    for (bool finished = false; ok && !finished;) {
        const int64_t steps = clod_free_stages_plan(&self->stages, self->from, &self->state);
        ok = clod_step_advance(&self->step, steps, status) && look(context, self, status);
        finished = ok && clod_free_stages_next(&self->stages, self->from, &self->state);
        clod_laws_set_adhesion(&self->laws, self->state.adhesion);
    }
    return ok;
}

static bool run_loaded(clod_verify_bed *self, clod_verify_bed_look look, void *context,
                       clod_status *status)
{
    const clod_step_options options = {0};
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
    if (!write_case(bench->directory, name, text, path, status)) {
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
