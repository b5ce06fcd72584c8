#include "sim/job.h"

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "base/memory.h"
#include "clod/ranks.h"
#include "clod/version.h"
#include "output/series.h"
#include "parallel/threads.h"
#include "setup/bound.h"
#include "setup/grains.h"
#include "sim/energy_series.h"
#include "sim/group.h"
#include "sim/job_bed.h"
#include "sim/job_steps.h"
#include "sim/job_store.h"
#include "sim/job_tables.h"
#include "sim/origin.h"
#include "sim/outputs.h"
#include "step/step.h"

#define FIRST_SLICE 64
#define SLICE_SHORTEST 0.05   ///< s of wall-clock time
#define SLICE_LONGEST 0.3     ///< s
#define PROGRESS_INTERVAL 0.5 ///< s of wall-clock time
#define SLOW_LEAST 1.0        ///< s that a checkpoint takes before it is called slow
#define SLOW_SHARE 0.25       ///< of the time between two

/** What exists only while the loop runs. */
typedef struct job_loop {
    clod_job *job;
    clod_laws laws;
    clod_step step;
    clod_job_tables tables;
    double *row;
    double last_clock, last_progress, last_checkpoint; ///< s
    clod_time_spent spent;                             ///< at most
    int64_t progress_step;
    int64_t slice;        ///< steps between two looks at clock and signals
    int64_t last_picture; ///< step of the last snapshot since the loop began; 0: none
    int saved;            ///< number of the last request to save that was heard
    bool said_slow;       ///< that checkpoints take long
} job_loop;

/** Say once that checkpoints take much of the time. */
static void tell_slow(job_loop *loop, double took)
{
    const double interval = loop->job->sim->from->output.checkpoint_interval;
    char text[512];
    if (loop->said_slow || took < SLOW_LEAST || took < SLOW_SHARE * interval) {
        return;
    }
    loop->said_slow = true;
    snprintf(
        text, sizeof text,
        "warning: %s: a checkpoint took %.3g s to write, and there is one every %.6g s: the "
        "file system of %s is slow. Raise output.checkpoint_interval, or write into a "
        "folder on another one with -o.",
        loop->job->name, took, interval, loop->job->sim->directory);
    clod_job_tell(loop->job, text);
}

/** Write everything; the tables first. */
static bool write_checkpoint(job_loop *loop, const char *suffix, clod_status *status)
{
    clod_job *job = loop->job;
    const double now = clod_clock_now();
    job->memory.wall_clock += now - loop->last_clock;
    loop->last_clock = loop->last_checkpoint = now;
    clod_step_bed view;
    const clod_bed_source bed = clod_step_bed_source(&loop->step, &view);
    const bool good = clod_step_see_gone(&loop->step, status) &&
                      clod_job_tables_mark(&loop->tables, job, status) &&
                      clod_job_store(job, &bed, suffix, status);
    const double took = clod_clock_now() - now;
    loop->spent.checkpoint = fmax(loop->spent.checkpoint, took);
    if (good) {
        tell_slow(loop, took);
    }
    return good;
}

/** Something of the procedure that looks at the bed; NULL: nothing. */
static bool with_survey(job_loop *loop,
                        bool (*run)(void *data, const void *context, clod_state *state,
                                    const clod_survey *survey, clod_status *status),
                        clod_status *status)
{
    clod_job *job = loop->job;
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(&loop->step, &reader);
    const clod_survey survey = clod_step_survey(&loop->step, &contacts);
    return run == NULL ||
           run(job->procedure.data, job->procedure.context, &job->state, &survey, status);
}

static bool write_snapshot(job_loop *loop, clod_status *status)
{
    loop->last_picture = loop->job->state.step;
    clod_step_bed view;
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(&loop->step, &reader);
    const clod_survey survey = clod_step_survey(&loop->step, &contacts);
    const clod_bed_source bed = clod_step_bed_source(&loop->step, &view);
    return clod_job_picture(loop->job, &survey, &bed, status);
}

/** Steps until a snapshot is due; very many when none ever is. */
static int64_t steps_to_snapshot(const clod_job *job)
{
    const double interval = job->sim->from->output.snapshot_interval;
    const int64_t now = job->state.step;
    return interval > 0.0 ? clod_outputs_next(interval, job->state.dt, now) - now : INT64_MAX;
}

/** A snapshot at its interval, whatever else is looked at when, and where something `ended`. */
static bool snapshot_if_due(job_loop *loop, bool ended, clod_status *status)
{
    const clod_job *job = loop->job;
    const double interval = job->sim->from->output.snapshot_interval;
    const bool due = clod_outputs_are_due(interval, job->state.dt, job->state.step);
    return !(due || ended) || write_snapshot(loop, status);
}

static void tell_progress(job_loop *loop, bool finished)
{
    const clod_job *job = loop->job;
    const clod_run_options *options = job->sim->options;
    const double now = clod_clock_now();
    const double since = now - loop->last_progress;
    if (options->progress == NULL || (since < PROGRESS_INTERVAL && !finished)) {
        return;
    }
    const double steps = (double)(job->state.step - loop->progress_step);
    const double fraction =
        job->procedure.fraction(job->procedure.data, job->procedure.context);
    const double spent = job->memory.wall_clock + now - loop->last_clock;
    options->progress(
        options->context,
        &(clod_progress){
            .part = job->name,
            .phase = job->procedure.phase(job->procedure.data, job->procedure.context),
            .time = job->state.time,
            .step = job->state.step,
            .grain_steps_per_s = steps * (double)clod_step_grains(&loop->step) / since,
            .fraction = fraction,
            .remaining = fraction > 0.02 ? spent * (1.0 - fraction) / fraction : -1.0,
            .finished = finished});
    loop->last_progress = now;
    loop->progress_step = job->state.step;
}

/**
 * Steps towards the procedure's next look or the next snapshot, as many as take some tenths of
 * a second: a signal is heard and a checkpoint is in time however far that is. How steps are
 * cut changes no bit.
 */
static bool advance(job_loop *loop, clod_status *status)
{
    clod_job_memory *memory = &loop->job->memory;
    const int64_t picture = steps_to_snapshot(loop->job);
    const int64_t next = memory->planned < picture ? memory->planned : picture;
    const int64_t steps = next < loop->slice ? next : loop->slice;
    const double begin = clod_clock_now();
    const int64_t before = loop->job->state.step;
    if (!clod_step_advance(&loop->step, steps, status)) {
        clod_status ignored;
        const int64_t made = loop->job->state.step - before; // perhaps one more than asked for
        memory->planned -= made < memory->planned ? made : memory->planned;
        write_checkpoint(loop, "-failed", &ignored);
        return false;
    }
    memory->planned -= steps;
    if (memory->planned == 0 && !clod_job_see(loop->job, &loop->step, status)) {
        return false;
    }
    const double spent = clod_clock_now() - begin;
    if (spent > SLICE_LONGEST) {
        loop->slice = steps > 1 ? steps / 2 : 1;
    } else if (spent < SLICE_SHORTEST && steps == loop->slice) {
        loop->slice *= 2;
    }
    return true;
}

/** Ask the procedure; what it could not go on with is kept beside the checkpoints. */
static bool can_go_on(job_loop *loop, clod_status *status)
{
    const clod_procedure *p = &loop->job->procedure;
    char text[512];
    if (p->trouble == NULL || !p->trouble(p->data, text, sizeof text)) {
        return true;
    }
    clod_status ignored;
    write_checkpoint(loop, "-failed", &ignored);
    return clod_status_fail(status, CLOD_FAILED, "%s, step %lld: %s", loop->job->name,
                            (long long)loop->job->state.step, text);
}

/**
 * The procedure's turn: it may change adhesion and ask for grains and walls to come or go. What
 * that does to the energy is no motion of grains: the ledger books it as exchanged.
 */
static bool sample(job_loop *loop, bool *finished, clod_status *status)
{
    clod_job *job = loop->job;
    const clod_procedure *p = &job->procedure;
    const bool books = loop->tables.energy != NULL;
    const clod_energies before = books ? clod_step_energies(&loop->step) : (clod_energies){0};
    if (books && !clod_energy_series_row(loop->tables.energy, &job->state, &before, status)) {
        return false;
    }
    if (!with_survey(loop, p->measure, status)) {
        return false;
    }
    const clod_survey survey = clod_step_survey(&loop->step, NULL);
    *finished = p->sample(p->data, p->context, &job->state, &survey, loop->row);
    clod_laws_set_adhesion(&loop->laws, job->state.adhesion);
    if (books) {
        clod_step_book(&loop->step, clod_energies_sum(&before));
    }
    return clod_step_change(&loop->step, status) &&
           clod_series_row(loop->tables.series, loop->row, status) &&
           clod_step_see_gone(&loop->step, status) &&
           clod_job_tables_leavers(&loop->tables, loop->job, status) && can_go_on(loop, status);
}

/** The procedure's look: a sample, and perhaps another phase. */
static bool look(job_loop *loop, clod_status *status)
{
    clod_job *job = loop->job;
    const clod_procedure *p = &job->procedure;
    const char *before = p->phase(p->data, p->context);
    bool finished = false;
    if (!sample(loop, &finished, status)) {
        return false;
    }
    const char *after = p->phase(p->data, p->context);
    job->memory.finished = finished;
    if ((before != after || (finished && p->reason != NULL)) &&
        !clod_job_log_phase(job, &loop->step, before, before != after ? after : "end",
                            status)) {
        return false;
    }
    tell_progress(loop, finished);
    return snapshot_if_due(loop, finished || before != after, status);
}

/** Say what the procedure has to say; in the log once, even when a run that was cut off comes by
 *  again. */
static void tell_news(const clod_job *job)
{
    const clod_procedure *p = &job->procedure;
    const clod_run_options *options = job->sim->options;
    clod_news news;
    while (p->news != NULL && p->news(p->data, p->context, &job->state, &news)) {
        if (options->notice != NULL) {
            options->notice(options->context, news.text);
        }
        clod_eventlog_write_once(job->sim->log, news.event, news.fields);
    }
}

/** One turn of the loop: steps, and when it is time for a look: measurement, output. */
static bool turn(job_loop *loop, clod_status *status)
{
    clod_job *job = loop->job;
    const clod_procedure *p = &job->procedure;
    if (job->memory.planned == 0) {
        if (!with_survey(loop, p->act, status)) {
            return false;
        }
        tell_news(job);
        job->memory.planned = p->plan(p->data, p->context, &job->state);
    }
    if (!advance(loop, status)) {
        return false;
    }
    const clod_survey survey = clod_step_survey(&loop->step, NULL);
    if (job->memory.planned == 0 &&
        (p->look == NULL || p->look(p->data, p->context, &job->state, &survey))) {
        return look(loop, status);
    }
    tell_progress(loop, false);
    return snapshot_if_due(loop, false, status);
}

static bool is_stopped(const clod_job *job)
{
    clod_group_hear(job->sim->group);
    return job->sim->options->stop != NULL && atomic_load(job->sim->options->stop) != 0;
}

static int save_request(const clod_job *job)
{
    return job->sim->options->save != NULL ? atomic_load(job->sim->options->save) : 0;
}

/** Somebody wants to see the state of now: a picture, and a checkpoint that is kept beside the
 *  usual two, which is written too so that the picture stays when the run is interrupted. */
static bool save_if_asked(job_loop *loop, clod_status *status)
{
    clod_job *job = loop->job;
    char suffix[32], stem[CLOD_JOB_STEM], text[256];
    const int request = save_request(job);
    if (request == loop->saved) {
        return true;
    }
    loop->saved = request;
    snprintf(suffix, sizeof suffix, "-at-%lld", (long long)job->state.step);
    if ((loop->last_picture != job->state.step && !write_snapshot(loop, status)) ||
        !write_checkpoint(loop, "", status) || !write_checkpoint(loop, suffix, status)) {
        return false;
    }
    clod_job_stem(job->name, suffix, stem);
    snprintf(text, sizeof text, "%s: %s_a.h5 and a snapshot are written, time %.9g s",
             job->name, stem, job->state.time);
    clod_job_tell(job, text);
    return true;
}

/** Whether the time limit asks for an end now. */
static bool is_late(const job_loop *loop)
{
    const clod_job_shared *sim = loop->job->sim;
    const int jobs = sim->options->threads / loop->job->threads; // side by side
    return clod_time_limit_is_near(&sim->limit, &loop->spent, jobs > 1 ? jobs : 1,
                                   clod_clock_now());
}

static bool checkpoint_is_due(const job_loop *loop)
{
    const clod_job_shared *sim = loop->job->sim;
    const double now = clod_clock_now();
    return now - loop->last_checkpoint > sim->from->output.checkpoint_interval ||
           clod_time_limit_asks(&sim->limit, &loop->spent, now);
}

/** What a run that was stopped says. */
static bool say_stopped(const clod_job *job, bool late, clod_status *status)
{
    char why[64] = "";
    if (late) {
        snprintf(why, sizeof why, " before the time limit of %.6g s", job->sim->limit.all);
    }
    return clod_status_fail(status, CLOD_INTERRUPTED,
                            "stopped at step %lld%s; the same command goes on from here",
                            (long long)job->state.step, why);
}

static bool loop_to_end(job_loop *loop, clod_status *status)
{
    clod_job *job = loop->job;
    while (job->memory.finished == 0) {
        const double begin = clod_clock_now();
        if (!turn(loop, status) || !save_if_asked(loop, status)) {
            return false;
        }
        loop->spent.turn = fmax(loop->spent.turn, clod_clock_now() - begin);
        const bool stop = is_stopped(job), late = is_late(loop);
        const bool end = stop || late || job->memory.finished != 0;
        if ((end || checkpoint_is_due(loop)) && !write_checkpoint(loop, "", status)) {
            return false;
        }
        if ((stop || late) && job->memory.finished == 0) {
            return say_stopped(job, late && !stop, status);
        }
    }
    return true;
}

static bool open_loop(job_loop *loop, clod_status *status)
{
    clod_job *job = loop->job;
    loop->row = clod_memory_alloc(job->procedure.column_count, sizeof *loop->row);
    if (loop->row == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a row of the series of %s",
                                job->name);
    }
    if (job->resumed && !clod_job_cut_pictures(job, status)) {
        return false;
    }
    const clod_step_options options = {.threads = clod_job_threads(job),
                                       .ranks = job->sim->options->ranks,
                                       .dealt = job->dealt ? &job->share : NULL,
                                       .simd = job->sim->options->simd,
                                       .overlap_limit = job->sim->from->time.overlap_limit,
                                       .accepts = clod_setup_bound_accepts,
                                       .context = job->sim->from};
    if (!clod_job_tables_open(&loop->tables, job, status) ||
        !clod_laws_init(&loop->laws, job->sim->from, status)) {
        return false;
    }
    clod_laws_set_adhesion(&loop->laws, job->state.adhesion);
    if (!clod_step_init(&loop->step, &job->state, &loop->laws, &options, status)) {
        return false;
    }
    loop->last_clock = loop->last_progress = loop->last_checkpoint = clod_clock_now();
    loop->progress_step = job->state.step;
    loop->saved = save_request(job);
    // a state that went through a checkpoint or another part has its ledger open
    return loop->tables.energy == NULL || job->state.ledger.open != 0 ||
           clod_step_open_ledger(&loop->step, status);
}

bool clod_job_run(clod_job *job, clod_status *status)
{
    char text[256];
    if (job->memory.finished != 0) {
        return clod_job_measure_finished(job, status);
    }
    if (!job->resumed) {
        if (job->state.step == 0 &&
            clod_outputs_say_short(job->sim->from, job->state.dt, text, sizeof text)) {
            clod_job_tell(job, text);
        }
        clod_job_bed_tell_solid(job);
        snprintf(job->memory.version, sizeof job->memory.version, "%s", clod_version_text());
        if (job->sim->origin != NULL) {
            memcpy(job->memory.origin, job->sim->origin->text, sizeof job->memory.origin);
        }
    }
    job_loop loop = {.job = job, .slice = FIRST_SLICE};
    // a first checkpoint before the first row: a table with rows always has one beside it
    bool ok = open_loop(&loop, status) &&
              (job->resumed || write_checkpoint(&loop, "", status)) &&
              (job->memory.planned > 0 || clod_job_see(job, &loop.step, status)); // to act
    if (ok) {
        ok = loop_to_end(&loop, status);
        ok = clod_job_measure_bed(job, &loop.step, status) && ok;
        clod_job_log_end(job, &loop.step, ok, status);
    }
    ok = clod_job_tables_close(&loop.tables, ok, status);
    clod_step_fini(&loop.step);
    clod_laws_fini(&loop.laws);
    clod_memory_free(loop.row);
    return ok;
}

void clod_job_fini(clod_job *job)
{
    clod_state_fini(&job->state);
    clod_crew_share_fini(&job->share);
}
