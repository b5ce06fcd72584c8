#include "sim/job_bed.h"

#include <math.h>

#include "measure/contacts.h"
#include "setup/stability.h"

/** 0 where it is not known, or nothing swings: that stops no run. */
static double stable_step(const clod_job *job, const clod_contact_source *contacts,
                          const clod_laws *laws)
{
    clod_stability found;
    clod_status ignored = {CLOD_OK, ""};
    clod_stability_measure(&found, &job->state, contacts, laws, &ignored);
    return isfinite(found.step) ? found.step : 0.0;
}

/** The same, once for a moment. */
static void note_stable_step(clod_job *job, const clod_contact_source *contacts,
                             const clod_laws *laws)
{
    if (!job->stable_known || job->stable_at != job->state.step) {
        job->stable_step = stable_step(job, contacts, laws);
        job->stable_at = job->state.step;
        job->stable_known = true;
    }
}

void clod_job_measure_bed(clod_job *job, clod_step *step)
{
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(step, &reader);
    job->bed = clod_measure_contacts_from(&job->state, &contacts);
    if (job->memory.finished != 0) { // one that stops for now goes on without it
        note_stable_step(job, &contacts, step->laws);
    }
    job->stepped = true;
}

clod_measure_contacts clod_job_bed(const clod_job *job)
{
    return job->stepped ? job->bed : clod_measure_contacts_of(&job->state);
}

double clod_job_stable_step(const clod_job *job)
{
    if (job->stable_known && job->stable_at == job->state.step) {
        return job->stable_step;
    }
    if (job->stepped) {
        return 0.0;
    }
    clod_laws laws;
    clod_status ignored = {CLOD_OK, ""};
    clod_contact_list list;
    const clod_contact_source contacts = clod_contact_source_of(&list, &job->state);
    double found = 0.0;
    if (clod_laws_init(&laws, job->sim->from, &ignored)) {
        clod_laws_set_adhesion(&laws, job->state.adhesion);
        found = stable_step(job, &contacts, &laws);
        clod_laws_fini(&laws);
    }
    return found;
}

void clod_job_log_phase(clod_job *job, clod_step *step, const char *before, const char *after)
{
    const clod_procedure *p = &job->procedure;
    const char *reason = p->reason != NULL ? p->reason(p->data) : NULL;
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(step, &reader);
    note_stable_step(job, &contacts, step->laws);
    clod_eventlog_write(job->sim->log, "phase", "{s:s, s:s, s:s, s:s*, s:I, s:f, s:f}", "part",
                        job->name, "from", before, "to", after, "reason", reason, "step",
                        (json_int_t)job->state.step, "time_s", job->state.time, "stable_step_s",
                        stable_step(job, &contacts, step->laws));
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
