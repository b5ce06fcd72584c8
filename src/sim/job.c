#include "sim/job.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "base/memory.h"
#include "clod/version.h"
#include "measure/contacts.h"
#include "output/checkpoint.h"
#include "output/series.h"
#include "output/snapshot.h"
#include "sim/energy_series.h"
#include "step/step.h"

#define PATH_MAX_TEXT 4096
#define FIRST_SLICE 64
#define SLICE_SHORTEST 0.05   ///< s of wall-clock time
#define SLICE_LONGEST 0.3     ///< s
#define PROGRESS_INTERVAL 0.5 ///< s of wall-clock time

/** Jobs run side by side in threads, and HDF5 is not thread-safe: one at a time. */
static pthread_mutex_t hdf5_lock = PTHREAD_MUTEX_INITIALIZER;

/** What exists only while the loop runs. */
typedef struct job_loop {
    clod_job *job;
    clod_laws laws;
    clod_step step;
    clod_series *series;
    clod_series *energy; ///< NULL without the ledger
    double *row;
    double last_clock, last_progress, last_checkpoint; ///< s
    int64_t progress_step;
    int64_t slice; ///< steps between two looks at clock and signals
} job_loop;

static double clock_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static size_t parts_of(clod_job *job, clod_job_memory *memory, clod_checkpoint_part parts[2])
{
    parts[0] = (clod_checkpoint_part){"procedure", job->procedure.data, job->procedure.size};
    parts[1] = (clod_checkpoint_part){"job", memory, sizeof *memory};
    return 2;
}

/** The only job of a free run is `run`: its files have plain names, those of others their own.
 */
static bool is_plain(const char *name)
{
    return strcmp(name, "run") == 0;
}

static void stem_of(const char *name, const char *suffix, char stem[80])
{
    if (is_plain(name)) {
        snprintf(stem, 80, "restart%s", suffix);
    } else {
        snprintf(stem, 80, "restart-%s%s", name, suffix);
    }
}

/** Read the checkpoint of the job called `name` into this one. */
static bool read_checkpoint(clod_job *job, const char *name, clod_job_memory *memory,
                            char *notice, size_t notice_size, clod_status *status)
{
    char stem[80];
    clod_checkpoint_part parts[2];
    const size_t count = parts_of(job, memory, parts);
    stem_of(name, "", stem);
    pthread_mutex_lock(&hdf5_lock);
    const bool ok = clod_checkpoint_read(job->sim->directory, stem, &job->state, parts, count,
                                         job->sim->identity, notice, notice_size, status);
    pthread_mutex_unlock(&hdf5_lock);
    return ok;
}

bool clod_job_begin_from(clod_job *job, const char *name, clod_status *status)
{
    char told[1]; // what is wrong with a checkpoint was told when that job went on from it
    clod_job_memory of_that_job;
    return read_checkpoint(job, name, &of_that_job, told, 0, status);
}

bool clod_job_resume(clod_job *job, clod_status *status)
{
    char stem[80];
    char notice[1024] = "";
    stem_of(job->name, "", stem);
    job->resumed = false;
    if (!clod_checkpoint_exists(job->sim->directory, stem)) {
        return true;
    }
    if (!read_checkpoint(job, job->name, &job->memory, notice, sizeof notice, status)) {
        return false;
    }
    job->resumed = true;
    if (strncmp(job->memory.version, clod_version_text(), CLOD_JOB_VERSION - 1) != 0) {
        const size_t used = strlen(notice);
        snprintf(
            notice + used, sizeof notice - used,
            "%s%s was begun by %s; this is another build, so its end may differ from that of "
            "one build throughout (--fresh starts over)",
            used > 0 ? "; " : "", job->name, job->memory.version);
    }
    if (notice[0] != '\0' && job->sim->options->notice != NULL) {
        job->sim->options->notice(job->sim->options->context, notice);
    }
    clod_eventlog_write(job->sim->log, "resume", "{s:s, s:I, s:f, s:s}", "part", job->name,
                        "step", (json_int_t)job->state.step, "time_s", job->state.time,
                        "notice", notice);
    return true;
}

/** The interval may be another one than before: do not wait for the end of the longer one. */
static void reschedule_snapshots(clod_job *job)
{
    const double interval = job->sim->from->output.snapshot_interval;
    if (job->memory.next_snapshot > job->state.time + 1.01 * interval) {
        job->memory.next_snapshot = job->state.time;
    }
}

/** Bring the history into the state and write everything; the series first. */
static bool write_checkpoint(job_loop *loop, const char *suffix, clod_status *status)
{
    clod_job *job = loop->job;
    char stem[80];
    clod_checkpoint_part parts[2];
    const size_t count = parts_of(job, &job->memory, parts);
    stem_of(job->name, suffix, stem);
    const double now = clock_now();
    job->memory.wall_clock += now - loop->last_clock;
    loop->last_clock = loop->last_checkpoint = now;
    job->memory.series_bytes = clod_series_bytes(loop->series);
    if (loop->energy != NULL) {
        job->memory.energy_bytes = clod_series_bytes(loop->energy);
        if (!clod_series_sync(loop->energy, status)) {
            return false;
        }
    }
    if (!clod_series_sync(loop->series, status) || !clod_step_export(&loop->step, status)) {
        return false;
    }
    pthread_mutex_lock(&hdf5_lock);
    const bool ok = clod_checkpoint_write(job->sim->directory, stem, &job->state, parts, count,
                                          job->sim->identity, status);
    pthread_mutex_unlock(&hdf5_lock);
    return ok;
}

static bool write_snapshot(job_loop *loop, clod_status *status)
{
    clod_job *job = loop->job;
    if (!clod_step_export(&loop->step, status)) {
        return false;
    }
    pthread_mutex_lock(&hdf5_lock);
    const bool ok = clod_snapshot_write(job->sim->directory, job->name, job->memory.snapshots++,
                                        &job->state, job->sim->from->output.contacts, status);
    pthread_mutex_unlock(&hdf5_lock);
    return ok;
}

static bool snapshot_if_due(job_loop *loop, bool ended, clod_status *status)
{
    clod_job *job = loop->job;
    const double interval = job->sim->from->output.snapshot_interval;
    const bool due = interval > 0.0 && job->state.time >= job->memory.next_snapshot;
    if (due) {
        job->memory.next_snapshot +=
            interval *
            ceil((job->state.time + 1e-3 * interval - job->memory.next_snapshot) / interval);
    }
    return !(due || ended) || write_snapshot(loop, status);
}

static void tell_progress(job_loop *loop, bool finished)
{
    const clod_job *job = loop->job;
    const clod_run_options *options = job->sim->options;
    const double now = clock_now();
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
            .grain_steps_per_s = steps * (double)job->state.grains.count / since,
            .fraction = fraction,
            .remaining = fraction > 0.02 ? spent * (1.0 - fraction) / fraction : -1.0,
            .finished = finished});
    loop->last_progress = now;
    loop->progress_step = job->state.step;
}

/**
 * Steps towards the procedure's next look, as many as take some tenths of a second: a signal is
 * heard and a checkpoint is in time however far the look is. How steps are cut changes no bit.
 */
static bool advance(job_loop *loop, clod_status *status)
{
    clod_job_memory *memory = &loop->job->memory;
    const int64_t steps = memory->planned < loop->slice ? memory->planned : loop->slice;
    const double begin = clock_now();
    if (!clod_step_advance(&loop->step, steps, status)) {
        clod_status ignored;
        write_checkpoint(loop, "-failed", &ignored);
        return false;
    }
    memory->planned -= steps;
    const double spent = clock_now() - begin;
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
 * The procedure's turn: it may take walls away and change adhesion. What that does to the
 * stored energy is no motion of grains: the ledger's opening balance moves by it.
 */
static bool sample(job_loop *loop, bool *finished, clod_status *status)
{
    clod_job *job = loop->job;
    const clod_procedure *p = &job->procedure;
    const bool books = loop->energy != NULL;
    const clod_energies before = books ? clod_step_energies(&loop->step) : (clod_energies){0};
    if (books && !clod_energy_series_row(loop->energy, &job->state, &before, status)) {
        return false;
    }
    *finished = p->sample(p->data, p->context, &job->state, loop->row);
    clod_laws_set_adhesion(&loop->laws, job->state.adhesion);
    if (books) {
        const clod_energies after = clod_step_energies(&loop->step);
        job->state.ledger.start += clod_energies_sum(&after) - clod_energies_sum(&before);
    }
    return clod_series_row(loop->series, loop->row, status) && can_go_on(loop, status);
}

/** One turn of the loop: steps, and when it is time for a look: measurement, output. */
static bool turn(job_loop *loop, clod_status *status)
{
    clod_job *job = loop->job;
    const clod_procedure *p = &job->procedure;
    if (job->memory.planned == 0) {
        job->memory.planned = p->plan(p->data, p->context, &job->state);
    }
    if (!advance(loop, status)) {
        return false;
    }
    if (job->memory.planned > 0) {
        tell_progress(loop, false);
        return true;
    }
    const char *before = p->phase(p->data, p->context);
    bool finished = false;
    if (!sample(loop, &finished, status)) {
        return false;
    }
    const char *after = p->phase(p->data, p->context);
    if (before != after) {
        clod_eventlog_write(job->sim->log, "phase", "{s:s, s:s, s:s, s:I, s:f}", "part",
                            job->name, "from", before, "to", after, "step",
                            (json_int_t)job->state.step, "time_s", job->state.time);
    }
    job->memory.finished = finished;
    tell_progress(loop, finished);
    return snapshot_if_due(loop, finished || before != after, status);
}

static bool is_stopped(const clod_job *job)
{
    return job->sim->options->stop != NULL && atomic_load(job->sim->options->stop) != 0;
}

static bool loop_to_end(job_loop *loop, clod_status *status)
{
    clod_job *job = loop->job;
    const double interval = job->sim->from->output.checkpoint_interval;
    while (job->memory.finished == 0) {
        if (!turn(loop, status)) {
            return false;
        }
        const bool stop = is_stopped(job);
        const bool due = clock_now() - loop->last_checkpoint > interval;
        if ((due || stop || job->memory.finished != 0) && !write_checkpoint(loop, "", status)) {
            return false;
        }
        if (stop && job->memory.finished == 0) {
            return clod_status_fail(status, CLOD_INTERRUPTED,
                                    "stopped at step %lld; the same command goes on from here",
                                    (long long)job->state.step);
        }
    }
    return true;
}

/** The ledger, which a state that went through a checkpoint or another part has open. */
static bool open_energy(job_loop *loop, clod_status *status)
{
    const clod_job *job = loop->job;
    char path[PATH_MAX_TEXT];
    snprintf(path, sizeof path, "%s/%s%senergy.csv", job->sim->directory,
             is_plain(job->name) ? "" : job->name, is_plain(job->name) ? "" : "-");
    loop->energy =
        clod_series_open(path, clod_energy_series_columns, CLOD_ENERGY_SERIES_COLUMNS,
                         job->resumed ? job->memory.energy_bytes : -1, status);
    return loop->energy != NULL &&
           (job->state.ledger.open != 0 || clod_step_open_ledger(&loop->step, status));
}

static bool open_loop(job_loop *loop, clod_status *status)
{
    clod_job *job = loop->job;
    char path[PATH_MAX_TEXT];
    snprintf(path, sizeof path, "%s/%s.csv", job->sim->directory,
             is_plain(job->name) ? "series" : job->name);
    loop->row = clod_memory_alloc(job->procedure.column_count, sizeof *loop->row);
    if (loop->row == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a row of %s", path);
    }
    if (job->resumed) {
        pthread_mutex_lock(&hdf5_lock);
        const bool ok =
            clod_snapshot_resume(job->sim->directory, job->name, job->state.time, status);
        pthread_mutex_unlock(&hdf5_lock);
        if (!ok) {
            return false;
        }
        reschedule_snapshots(job);
    }
    loop->series = clod_series_open(path, job->procedure.columns, job->procedure.column_count,
                                    job->resumed ? job->memory.series_bytes : -1, status);
    const clod_step_options options = {.threads = job->threads,
                                       .simd = job->sim->options->simd};
    if (loop->series == NULL || !clod_laws_init(&loop->laws, job->sim->from, status)) {
        return false;
    }
    clod_laws_set_adhesion(&loop->laws, job->state.adhesion);
    if (!clod_step_init(&loop->step, &job->state, &loop->laws, &options, status)) {
        return false;
    }
    loop->last_clock = loop->last_progress = loop->last_checkpoint = clock_now();
    loop->progress_step = job->state.step;
    return !job->sim->from->output.energy || open_energy(loop, status);
}

static void log_end(job_loop *loop, const clod_job *job, bool ok, const clod_status *status)
{
    clod_status ignored;
    clod_step_export(&loop->step, &ignored); // after most ends it is done already
    const clod_measure_contacts bed = clod_measure_contacts_of(&job->state);
    clod_eventlog_write(job->sim->log, ok ? "finished" : "stopped",
                        "{s:s, s:I, s:f, s:f, s:i, s:I, s:I, s:I, s:f, s:f, s:s}", "part",
                        job->name, "step", (json_int_t)job->state.step, "time_s",
                        job->state.time, "wall_clock_s", job->memory.wall_clock, "threads",
                        loop->step.threads, "rebuilds", (json_int_t)loop->step.rebuilds,
                        "refreshes", (json_int_t)loop->step.refreshes, "contacts",
                        (json_int_t)bed.pairs, "coordination", bed.coordination, "max_overlap",
                        bed.max_overlap, "message", ok ? "" : status->text);
}

bool clod_job_run(clod_job *job, clod_status *status)
{
    if (job->memory.finished != 0) {
        return true;
    }
    if (!job->resumed) {
        snprintf(job->memory.version, sizeof job->memory.version, "%s", clod_version_text());
    }
    job_loop loop = {.job = job, .slice = FIRST_SLICE};
    bool ok = open_loop(&loop, status);
    if (ok) {
        ok = loop_to_end(&loop, status);
        log_end(&loop, job, ok, status);
    }
    clod_step_fini(&loop.step);
    clod_laws_fini(&loop.laws);
    clod_series_close(&loop.series);
    clod_series_close(&loop.energy);
    clod_memory_free(loop.row);
    return ok;
}

void clod_job_fini(clod_job *job)
{
    clod_state_fini(&job->state);
}
