#include "sim/job_bed.h"

#include <math.h>
#include <stdio.h>

#include "config/grain_solid.h"
#include "measure/contacts.h"
#include "setup/stability.h"
#include "sim/job_store.h"
#include "tester/limits.h"

/** The largest stable step of now, once for a moment. */
static bool note_stable_step(clod_job *job, const clod_contact_source *contacts,
                             const clod_laws *laws, clod_status *status)
{
    if (job->stable_known && job->stable_at == job->state.step) {
        return true;
    }
    clod_stability found;
    job->stable_known = clod_stability_measure(&found, &job->state, contacts, laws, status);
    job->stable_step = job->stable_known && isfinite(found.step) ? found.step : 0.0;
    job->stable_at = job->state.step;
    return job->stable_known;
}

/** The same of a bed that is stepped; a large one is not even looked at. */
static bool see_stable_step(clod_job *job, clod_step *step, clod_status *status)
{
    if (clod_step_grains(step) > CLOD_LIMITS_STABLE_GRAINS) {
        return true;
    }
    if (!clod_step_see(step, status)) {
        return false;
    }
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(step, &reader);
    return note_stable_step(job, &contacts, step->laws, status);
}

bool clod_job_measure_bed(clod_job *job, clod_step *step, clod_status *status)
{
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(step, &reader);
    const clod_survey survey = clod_step_survey(step, &contacts);
    job->stepped = true;
    if (!clod_measure_contacts_from(&survey, &job->bed, status)) {
        return false;
    }
    job->motion = clod_measure_motion_from(&survey);
    // one that stops for now goes on without it
    return job->memory.finished == 0 || see_stable_step(job, step, status);
}

bool clod_job_measure_finished(clod_job *job, clod_status *status)
{
    clod_laws laws;
    clod_contact_list list;
    const clod_contact_source contacts = clod_contact_source_of(&list, &job->state);
    if (!clod_laws_init(&laws, job->sim->from, status)) {
        return false;
    }
    clod_laws_set_adhesion(&laws, job->state.adhesion);
    const bool good = job->state.grains.count > CLOD_LIMITS_STABLE_GRAINS ||
                      note_stable_step(job, &contacts, &laws, status);
    clod_laws_fini(&laws);
    return good;
}

clod_measure_contacts clod_job_bed(const clod_job *job)
{
    return job->stepped ? job->bed : clod_measure_contacts_of(&job->state);
}

clod_measure_motion clod_job_motion(const clod_job *job)
{
    return job->stepped ? job->motion : clod_measure_motion_of(&job->state);
}

double clod_job_stable_step(const clod_job *job)
{
    return job->stable_known && job->stable_at == job->state.step ? job->stable_step : 0.0;
}

bool clod_job_log_phase(clod_job *job, clod_step *step, const char *before, const char *after,
                        clod_status *status)
{
    const clod_procedure *p = &job->procedure;
    const char *reason = p->reason != NULL ? p->reason(p->data) : NULL;
    const bool good = see_stable_step(job, step, status);
    clod_eventlog_write(job->sim->log, "phase", "{s:s, s:s, s:s, s:s*, s:I, s:f, s:f}", "part",
                        job->name, "from", before, "to", after, "reason", reason, "step",
                        (json_int_t)job->state.step, "time_s", job->state.time, "stable_step_s",
                        clod_job_stable_step(job));
    return good;
}

void clod_job_log_end(const clod_job *job, const clod_step *step, bool ok,
                      const clod_status *status)
{
    const clod_measure_contacts bed = clod_job_bed(job);
    clod_eventlog_write(
        job->sim->log, ok ? "finished" : "stopped",
        "{s:s, s:I, s:f, s:f, s:i, s:I, s:I, s:I, s:f, s:f, s:f, s:s}", "part", job->name,
        "step", (json_int_t)job->state.step, "time_s", job->state.time, "wall_clock_s",
        job->memory.wall_clock, "threads", step->threads, "rebuilds",
        (json_int_t)step->rebuilds, "refreshes", (json_int_t)step->refreshes, "contacts",
        (json_int_t)bed.pairs, "coordination", bed.coordination, "max_overlap", bed.max_overlap,
        "stable_step_s", clod_job_stable_step(job), "message", ok ? "" : status->text);
}

void clod_job_bed_tell_solid(const clod_job *job)
{
    bool (*const looks[])(const clod_case *, char *, size_t) = {clod_grain_solid_differs,
                                                                clod_grain_solid_missed};
    for (size_t k = 0; k < sizeof looks / sizeof looks[0] && job->state.step == 0; k++) {
        char text[CLOD_SOLID_TEXT];
        char line[CLOD_SOLID_TEXT + 16];
        if (looks[k](job->sim->from, text, sizeof text)) {
            snprintf(line, sizeof line, "warning: %s", text);
            clod_job_tell(job, line);
        }
    }
}
