#include "sim/job_store.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "base/text.h"
#include "clod/version.h"
#include "output/checkpoint.h"
#include "output/folder_files.h"
#include "output/series.h"
#include "output/snapshot.h"
#include "sim/deal.h"
#include "sim/leavers_table.h"
#include "sim/origin.h"

static pthread_mutex_t hdf5_lock = PTHREAD_MUTEX_INITIALIZER;

/** Parts of a checkpoint, at most. */
#define PARTS 3

static size_t parts_of(clod_job *self, clod_job_memory *memory,
                       clod_checkpoint_part parts[PARTS])
{
    const clod_procedure *p = &self->procedure;
    parts[0] = (clod_checkpoint_part){"procedure", p->data, p->size};
    parts[1] = (clod_checkpoint_part){"job", memory, sizeof *memory};
    if (p->measures_size == 0) {
        return 2;
    }
    unsigned char *measures = (unsigned char *)p->data + p->size;
    parts[2] = (clod_checkpoint_part){"measures", measures, p->measures_size};
    return 3;
}

bool clod_job_is_plain(const clod_job *self)
{
    return strcmp(self->name, "run") == 0;
}

void clod_job_stem(const char *name, const char *suffix, char stem[CLOD_JOB_STEM])
{
    if (strcmp(name, "run") == 0) {
        snprintf(stem, CLOD_JOB_STEM, "restart%s", suffix);
    } else {
        snprintf(stem, CLOD_JOB_STEM, "restart-%s%s", name, suffix);
    }
}

void clod_job_tell(const clod_job *self, const char *text)
{
    const clod_run_options *options = self->sim->options;
    if (options->notice != NULL) {
        options->notice(options->context, text);
    }
    clod_eventlog_write(self->sim->log, "notice", "{s:s, s:s}", "part", self->name, "text",
                        text);
}

bool clod_job_store(clod_job *self, const clod_bed_source *bed, const char *suffix,
                    clod_status *status)
{
    char stem[CLOD_JOB_STEM];
    clod_checkpoint_part parts[PARTS];
    const size_t count = parts_of(self, &self->memory, parts);
    clod_job_stem(self->name, suffix, stem);
    pthread_mutex_lock(&hdf5_lock);
    const bool ok = clod_checkpoint_write(self->sim->folder, stem, &self->state, bed, parts,
                                          count, self->sim->identity, status);
    pthread_mutex_unlock(&hdf5_lock);
    return ok;
}

void clod_job_table_names(const char *name, char series[CLOD_JOB_STEM],
                          char energy[CLOD_JOB_STEM])
{
    const bool plain = strcmp(name, "run") == 0;
    snprintf(series, CLOD_JOB_STEM, "%s.csv", plain ? "series" : name);
    snprintf(energy, CLOD_JOB_STEM, "%s%senergy.csv", plain ? "" : name, plain ? "" : "-");
}

static clod_frame frame_of(const clod_job *self)
{
    return (clod_frame){self->sim->folder, self->memory.snapshots,
                        clod_job_is_plain(self) ? NULL : self->name};
}

bool clod_job_write_files(clod_job *self, clod_status *status)
{
    const clod_procedure *p = &self->procedure;
    const clod_frame frame = frame_of(self);
    if (p->write == NULL) {
        return true;
    }
    pthread_mutex_lock(&hdf5_lock);
    const bool ok = p->write(p->data, p->context, &self->state, &frame, status);
    pthread_mutex_unlock(&hdf5_lock);
    return ok;
}

bool clod_job_picture(clod_job *self, const clod_survey *survey, const clod_bed_source *bed,
                      clod_status *status)
{
    const clod_procedure *p = &self->procedure;
    const clod_frame frame = frame_of(self);
    pthread_mutex_lock(&hdf5_lock);
    const bool ok = (p->picture == NULL ||
                     p->picture(p->data, p->context, &self->state, survey, &frame, status)) &&
                    clod_snapshot_write(self->sim->folder, self->name, self->memory.snapshots++,
                                        &self->state, bed, self->sim->from->output.contacts,
                                        &self->memory.film, status);
    pthread_mutex_unlock(&hdf5_lock);
    return ok;
}

bool clod_job_cut_pictures(const clod_job *self, clod_status *status)
{
    pthread_mutex_lock(&hdf5_lock);
    const bool ok =
        clod_snapshot_resume(self->sim->folder, self->name, self->state.time, status);
    pthread_mutex_unlock(&hdf5_lock);
    return ok;
}

/** A folder whose checkpoints are read, and the case that they must have; NULL: any. */
typedef struct shelf {
    const clod_folder *folder;
    const char *identity;
} shelf;

/** Read the checkpoint of the job called `name` into this one. */
static bool read_checkpoint(clod_job *self, const shelf *where, const char *name,
                            clod_job_memory *memory, const clod_bed_taker *taker,
                            char notice[1024], clod_status *status)
{
    char stem[CLOD_JOB_STEM];
    clod_checkpoint_part parts[PARTS];
    const size_t count = parts_of(self, memory, parts);
    const clod_checkpoint_wanted wanted = {parts, count, where->identity, taker};
    clod_job_stem(name, "", stem);
    pthread_mutex_lock(&hdf5_lock);
    const bool ok =
        clod_checkpoint_get(where->folder, stem, &self->state, &wanted, notice, 1024, status);
    pthread_mutex_unlock(&hdf5_lock);
    return ok;
}

bool clod_job_begin_from(clod_job *job, const char *name, clod_status *status)
{
    char told[1024]; // what is wrong with a checkpoint was told when that job went on from it
    const shelf own = {job->sim->folder, job->sim->identity};
    clod_job_memory of_that_job;
    if (!read_checkpoint(job, &own, name, &of_that_job, NULL, told, status)) {
        return false;
    }
    memcpy(job->memory.origin, of_that_job.origin, sizeof job->memory.origin); // its grains
    return true;
}

static int32_t shapes_of(const clod_walls *walls)
{
    int32_t count = 0;
    for (int32_t w = 0; w < walls->count; w++) {
        count += walls->wall[w].shape_count;
    }
    return count;
}

/** Read the finished job of the other run; its tables have the marks of before. */
static bool read_origin(clod_job *job, char notice[1024], clod_status *status)
{
    clod_origin *origin = job->sim->origin;
    const double needed = job->state.dt;
    const int32_t shapes = shapes_of(&job->state.walls);
    notice[0] = '\0';
    if (!clod_origin_open(origin, job->sim, status)) {
        return false;
    }
    const shelf other = {origin->shelf, NULL};
    if (!read_checkpoint(job, &other, job->name, &job->memory, NULL, notice, status)) {
        return clod_origin_fail(origin, status);
    }
    // all else of the cell is the same, or the cases would have been told apart before
    if (shapes_of(&job->state.walls) != shapes) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "--from %s: the plate with ridges there is not as long as this "
            "programme needs, which follows from the number of stresses and "
            "shear_max; run this case without --from",
            origin->folder);
    }
    if (job->memory.finished == 0 || job->state.dt > needed * (1.0 + 1e-9)) {
        return clod_status_fail(
            status, CLOD_USAGE,
            job->memory.finished == 0
                ? "--from %s: its %s is not finished; let that run come to its end first"
                : "--from %s: the time step of its %s is longer than this case needs; run this "
                  "case without --from",
            origin->folder, job->name);
    }
    return true;
}

/**
 * Look at a table of the other run as far as its checkpoint knows it, and copy it if asked to;
 * one that is not there is left out, and has a mark of no bytes.
 */
static bool take_table(const clod_job *job, const char *name, clod_series_mark *mark, bool copy,
                       clod_status *status)
{
    void *bytes;
    size_t size;
    const clod_folder *other = job->sim->origin->shelf;
    if (!clod_folder_read(other, name, &bytes, &size, status)) {
        return clod_origin_fail(job->sim->origin, status);
    }
    if (bytes == NULL || mark->bytes == 0) {
        clod_memory_free(bytes);
        *mark = (clod_series_mark){0};
        return true;
    }
    const bool ok = (clod_series_check(other, name, mark, status) ||
                     clod_origin_fail(job->sim->origin, status)) &&
                    (!copy || clod_folder_replace(job->sim->folder, name, bytes,
                                                  (size_t)mark->bytes, NULL, 0, status));
    clod_memory_free(bytes);
    return ok;
}

static bool take_tables(clod_job *job, bool copy, clod_status *status)
{
    char series[CLOD_JOB_STEM], energy[CLOD_JOB_STEM];
    clod_job_table_names(job->name, series, energy);
    return take_table(job, series, &job->memory.series, copy, status) &&
           take_table(job, energy, &job->memory.energy, copy, status);
}

bool clod_job_try_origin(clod_job *job, clod_status *status)
{
    char told[1024]; // what is wrong with a checkpoint is told when it is taken over
    return read_origin(job, told, status) && take_tables(job, false, status);
}

/** Tell what was taken over; the first part of a test also tells in what the cases differ. */
static bool tell_taken(const clod_job *job, clod_status *status)
{
    clod_text text;
    clod_origin *origin = job->sim->origin;
    FILE *out = clod_text_open(&text);
    char *told = NULL;
    if (out != NULL) {
        fprintf(out, "%s is taken over from %s, step %lld, time %.9g s: %zu grains", job->name,
                origin->text, (long long)job->state.step, job->state.time,
                job->state.grains.count);
        if (!atomic_exchange(&origin->told, true)) {
            fputc('\n', out);
            clod_origin_print_differences(origin, out);
        }
        told = clod_text_close(&text);
    }
    if (told == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory to tell what is taken over");
    }
    clod_job_tell(job, told);
    clod_memory_free(told);
    return true;
}

bool clod_job_take_over(clod_job *job, clod_status *status)
{
    char notice[1024];
    // a table with rows always has a checkpoint beside it, and this one is of before them
    if (!clod_job_store(job, NULL, "", status) || !read_origin(job, notice, status)) {
        return false;
    }
    const clod_origin *origin = job->sim->origin;
    job->memory.snapshots = 0;
    job->memory.film = (clod_snapshot_film){0};
    memcpy(job->memory.origin, origin->text, sizeof job->memory.origin);
    if (notice[0] != '\0') {
        clod_job_tell(job, notice);
    }
    if (!take_tables(job, true, status) || !tell_taken(job, status)) {
        return false;
    }
    clod_eventlog_write(job->sim->log, "taken over", "{s:s, s:s, s:I, s:f}", "part", job->name,
                        "from", origin->text, "step", (json_int_t)job->state.step, "time_s",
                        job->state.time);
    return true;
}

/** Whether a table is what it was at the checkpoint; one that was not taken over is none. */
static bool check_table(const clod_folder *folder, const char *name,
                        const clod_series_mark *mark, clod_status *status)
{
    return mark->bytes == 0 || clod_series_check(folder, name, mark, status);
}

/** Whether all that lies before the checkpoint is whole; nothing is cut off before that. */
static bool check_results(const clod_job *job, clod_status *status)
{
    const clod_folder *folder = job->sim->folder;
    char series[CLOD_JOB_STEM], energy[CLOD_JOB_STEM];
    clod_job_table_names(job->name, series, energy);
    return check_table(folder, series, &job->memory.series, status) &&
           (!job->sim->from->output.energy ||
            check_table(folder, energy, &job->memory.energy, status)) &&
           check_table(folder, CLOD_LEAVERS_TABLE, &job->memory.leavers, status) &&
           clod_snapshot_check(folder, job->name, job->state.time, &job->memory.film, status);
}

/** Whether a checkpoint is that of before a job is taken over: it has no table yet. */
static bool is_before(const clod_job_memory *memory)
{
    return memory->finished == 0 && memory->series.bytes == 0;
}

/** Read the job's own checkpoint; several ranks get the bed of a free run as it is read. */
static bool read_own(clod_job *job, const shelf *own, char notice[1024], clod_status *status)
{
    clod_deal deal;
    const bool free = clod_case_tester(job->sim->from) == NULL; // a test has a state already
    const clod_bed_taker *taker = clod_deal_again(&deal, free ? job->sim->options->ranks : NULL,
                                                  &job->share, &job->memory.finished);
    const bool good = read_checkpoint(job, own, job->name, &job->memory, taker, notice, status);
    job->dealt = good && taker != NULL && job->memory.finished == 0;
    clod_deal_fini(&deal);
    return good;
}

bool clod_job_resume(clod_job *job, clod_status *status)
{
    char stem[CLOD_JOB_STEM];
    char notice[1024] = "";
    const shelf own = {job->sim->folder, job->sim->identity};
    clod_job_stem(job->name, "", stem);
    job->resumed = false;
    bool exists;
    if (!clod_checkpoint_exists(job->sim->folder, stem, &exists, status)) {
        return false;
    }
    if (!exists) {
        return true;
    }
    if (!read_own(job, &own, notice, status)) {
        return false;
    }
    if (is_before(&job->memory)) {
        CLOD_ASSERT(!job->dealt); // a part begins with a bed that rank 0 has (read_own)
        if (notice[0] != '\0') {
            clod_job_tell(job, notice);
        }
        return true;
    }
    if (!clod_origin_is_that(job->sim->origin, job->memory.origin, job->sim->directory,
                             status) ||
        !check_results(job, status)) {
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
