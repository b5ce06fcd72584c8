#include "sim/parts.h"

#include <limits.h>
#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

#include "base/clock.h"
#include "base/memory.h"
#include "base/plural.h"
#include "clod/locus.h"
#include "clod/ranks.h"
#include "clod/version.h"
#include "config/grain_solid.h"
#include "measure/contacts.h"
#include "output/folder_files.h"
#include "parallel/threads.h"
#include "setup/begin.h"
#include "sim/group.h"
#include "sim/job_store.h"
#include "sim/part_measures.h"
#include "sim/testers.h"
#include "sim/warning_box.h"
#include "tester/limits.h"

/** Parts that may run side by side. */
typedef struct part_batch {
    const clod_parts_tester *tester;
    const clod_job_shared *sim;
    clod_part *part; ///< [count]
    clod_part_measures measures;
    int threads;        ///< of each part
    atomic_bool failed; ///< a part has: no further one is begun
} part_batch;

static void init_job(const part_batch *batch, clod_part *part, clod_job *job)
{
    *job = (clod_job){
        .sim = batch->sim, .threads = batch->threads, .procedure = batch->tester->procedure};
    memcpy(job->name, part->name, sizeof job->name);
    job->procedure.data = part->test;
    clod_part_measures_join(&batch->measures, &job->procedure);
}

/** Take a preparation over from another run, as a finished part of this one. */
static bool take_over(const part_batch *batch, clod_part *part, clod_job *job,
                      clod_status *status)
{
    if (!clod_job_take_over(job, status)) {
        return false;
    }
    batch->tester->adopt(batch->sim->from, part);
    return clod_job_store(job, NULL, "", status);
}

/** Whether a part is not run but copied from another run: a preparation, as all of its batch. */
static bool is_taken_over(const clod_job_shared *sim, const clod_part *part)
{
    return sim->origin != NULL && part->point < 0;
}

static bool begin(const part_batch *batch, clod_part *part, clod_job *job, clod_status *status)
{
    if (is_taken_over(batch->sim, part)) {
        return take_over(batch, part, job, status);
    }
    if (part->from[0] != '\0' && !clod_job_begin_from(job, part->from, status)) {
        return false;
    }
    batch->tester->begin(batch->sim->from, part, &job->state);
    clod_part_measures_begin(&batch->measures, part->test, &job->state);
    return true;
}

static void note_result(const clod_job *job, clod_part *part)
{
    const clod_measure_contacts bed = clod_job_bed(job);
    part->steps = job->state.step;
    part->dt = job->state.dt;
    part->wall_clock = job->memory.wall_clock;
    memcpy(part->version, job->memory.version, sizeof part->version);
    memcpy(part->origin, job->memory.origin, sizeof part->origin);
    part->grains = (size_t)clod_job_motion(job).grains; // ranks may have them
    part->coordination = bed.coordination;
    part->max_overlap = bed.max_overlap;
    part->mean_overlap = bed.mean_overlap;
    part->stable_step = clod_job_stable_step(job);
}

/** Whether a part may begin: not after a signal, nor at the end of its time, nor when another part has failed. */
static bool may_begin(part_batch *batch, clod_part *part)
{
    const clod_run_options *options = batch->sim->options;
    const bool stop = options->stop != NULL && atomic_load(options->stop) != 0;
    const bool late =
        clod_time_limit_is_near(&batch->sim->limit, &(clod_time_spent){0}, 1, clod_clock_now());
    const clod_group *group = batch->sim->group;
    const bool failed = atomic_load(&batch->failed) || (group != NULL && group->failed);
    if (stop || late || failed) {
        return clod_status_fail(&part->status, CLOD_INTERRUPTED,
                                "%s was not begun; the same command goes on from here",
                                part->name);
    }
    return true;
}

static void run_part(void *context, int number)
{
    part_batch *batch = context;
    clod_part *part = &batch->part[number];
    if (!may_begin(batch, part)) {
        return;
    }
    clod_job job;
    init_job(batch, part, &job);
    part->ok = clod_begin_state(batch->sim->from, part->seed, &job.state, &part->status) &&
               clod_job_resume(&job, &part->status) &&
               (job.resumed || begin(batch, part, &job, &part->status)) &&
               clod_job_run(&job, &part->status) && clod_job_write_files(&job, &part->status);
    if (part->ok) {
        note_result(&job, part);
    } else if (part->status.code != CLOD_INTERRUPTED) {
        atomic_store(&batch->failed, true);
    }
    clod_job_fini(&job);
}

void clod_parts_run_one(const clod_parts_tester *tester, const clod_job_shared *sim,
                        clod_part *part)
{
    const int given = sim->options->threads;
    part_batch batch = {.tester = tester,
                        .sim = sim,
                        .part = part,
                        .threads = given > 0 ? given : clod_threads_available()};
    if (clod_part_measures_init(&batch.measures, sim->from, &tester->procedure,
                                &part->status)) {
        run_part(&batch, 0);
    }
    clod_part_measures_fini(&batch.measures);
}

/** The parts of a batch in threads, as many as there are; ranks step one after the other. */
static bool run_in_threads(const clod_parts_tester *tester, const clod_job_shared *sim,
                           clod_part *part, int count, clod_status *status)
{
    const int given = sim->options->threads;
    const int threads = given > 0 ? given : clod_threads_available();
    const clod_ranks *ranks = sim->options->ranks;
    const bool several = ranks != NULL && clod_ranks_size(ranks) > 1;
    const int workers = several ? 1 : count < threads ? count : threads;
    part_batch batch = {.tester = tester,
                        .sim = sim,
                        .part = part,
                        .threads = threads / workers > 0 ? threads / workers : 1};
    const bool good =
        clod_part_measures_init(&batch.measures, sim->from, &tester->procedure, status);
    if (good) {
        clod_threads_run(count, workers, run_part, &batch);
    }
    clod_part_measures_fini(&batch.measures);
    return good;
}

bool clod_parts_run(const clod_parts_tester *tester, const clod_job_shared *sim,
                    clod_part *part, int count, clod_status *status)
{
    // rank 0 copies, so no other host needs that run; points have its name from their preparation
    const bool copied = is_taken_over(sim, &part[0]);
    const int groups = copied ? 1 : clod_group_count(sim->options->ranks, count);
    bool ok = groups > 1 ? clod_group_run(tester, sim, part, count, groups, status)
                         : run_in_threads(tester, sim, part, count, status);
    const bool begun = ok;
    for (int p = 0; begun && p < count; p++) {
        if (!part[p].ok && (ok || status->code == CLOD_INTERRUPTED)) {
            *status = part[p].status;
            ok = false;
        }
    }
    return ok;
}

clod_part *clod_parts_create(const clod_parts_tester *tester, const clod_case *from, int count,
                             clod_status *status)
{
    const size_t size = tester->procedure.size + clod_part_measures_size(from);
    clod_part *self = clod_memory_alloc((size_t)count, sizeof *self);
    char *tests = clod_memory_alloc((size_t)count, size);
    if (self == NULL || tests == NULL) {
        clod_memory_free(self);
        clod_memory_free(tests);
        clod_status_fail(status, CLOD_FAILED, "no memory for the parts of the test");
        return NULL;
    }
    for (int p = 0; p < count; p++) {
        self[p].test = tests + (size_t)p * size;
    }
    return self;
}

void clod_parts_destroy(clod_part *self)
{
    if (self != NULL) {
        clod_memory_free(self[0].test); // that of all
        clod_memory_free(self);
    }
}

void clod_parts_warn_end(json_t *list, const clod_part *part)
{
    if (part->max_overlap > CLOD_LIMITS_OVERLAP_MOST) {
        clod_warning_box_add(
            list,
            "%s: overlap up to %.1f %% of a radius at its end; the laws assume "
            "small ones: raise the stiffness",
            part->name, 100.0 * part->max_overlap);
    }
    if (part->stable_step > 0.0 && part->dt > CLOD_LIMITS_STABLE * part->stable_step) {
        clod_warning_box_add(list,
                             "%s: the time step, %.3g s, is %.2g of the largest stable one of "
                             "the bed at its end, %.3g s: lower time.safety or time.step",
                             part->name, part->dt, part->dt / part->stable_step,
                             part->stable_step);
    }
}

bool clod_parts_try_origin(const clod_parts_tester *tester, const clod_job_shared *sim,
                           clod_part *part, int count, clod_status *status)
{
    part_batch batch = {.tester = tester, .sim = sim};
    bool ok = clod_part_measures_init(&batch.measures, sim->from, &tester->procedure, status);
    for (int p = 0; ok && p < count; p++) {
        clod_job job;
        init_job(&batch, &part[p], &job);
        ok = clod_begin_state(sim->from, part[p].seed, &job.state, status) &&
             clod_job_try_origin(&job, status);
        clod_job_fini(&job);
    }
    clod_part_measures_fini(&batch.measures);
    return ok;
}

json_t *clod_parts_json(const clod_part *part)
{
    const struct {
        const char *key;
        double value;
    } NUMBERS[] = {{"dt_s", part->dt},
                   {"wall_clock_s", part->wall_clock},
                   {"coordination", part->coordination},
                   {"max_overlap", part->max_overlap},
                   {"mean_overlap", part->mean_overlap},
                   {"stable_step_s", part->stable_step}};
    json_t *from = part->origin[0] != '\0' ? json_string(part->origin) : NULL;
    json_t *j = json_pack("{s:s, s:s, s:o*, s:I, s:I, s:I}", "part", part->name, "version",
                          part->version, "from", from, "seed", (json_int_t)part->seed, "steps",
                          (json_int_t)part->steps, "grains", (json_int_t)part->grains);
    for (size_t k = 0; k < sizeof NUMBERS / sizeof *NUMBERS; k++) {
        clod_parts_set_number(j, NUMBERS[k].key, NUMBERS[k].value);
    }
    return j;
}

bool clod_parts_put_measures(json_t *object, const clod_job_shared *sim, const clod_part *part,
                             clod_status *status)
{
    const clod_procedure *tester = &clod_testers_of(sim->from)->first->procedure;
    return clod_part_measures_put(object, sim->from, tester, sim->folder, part->name,
                                  (const char *)part->test + tester->size, status);
}

void clod_parts_set_number(json_t *object, const char *key, double value)
{
    json_object_set_new(object, key, isfinite(value) ? json_real(value) : json_null());
}

bool clod_parts_write_summary(const clod_job_shared *sim, json_t *parts, const char *name,
                              json_t *results, json_t *warnings, const char *incomplete,
                              clod_status *status)
{
    char text[CLOD_SOLID_TEXT];
    json_t *all = json_copy(warnings);
    if (clod_grain_solid_missed(sim->from, text, sizeof text)) {
        json_array_append_new(all, json_string(text));
    }
    json_t *root = json_pack("{s:s, s:s, s:s*, s:o, s:o?, s:o}", "title",
                             sim->from->title != NULL ? sim->from->title : "", "version",
                             clod_version_text(), "incomplete", incomplete, "parts", parts,
                             name, results, "warnings", all);
    const bool ok = clod_folder_write_json(sim->folder, "summary.json", root, status);
    json_decref(root);
    return ok;
}

bool clod_parts_write_locus(const clod_job_shared *sim, const clod_parts_locus *how,
                            const clod_part *part, int parts, char *text, json_t *warnings,
                            const char *incomplete, clod_status *status)
{
    json_t *results = text != NULL ? json_loads(text, 0, NULL) : NULL;
    clod_locus_free(text);
    if (results == NULL && incomplete == NULL) { // it would look like no result
        return clod_status_fail(status, CLOD_FAILED, "%s/summary.json: no memory for the locus",
                                sim->directory);
    }
    json_t *list = json_array();
    for (int p = 0; p < parts; p++) {
        json_t *one = how->part(&part[p]);
        json_array_append_new(list, one);
        if (!clod_parts_put_measures(one, sim, &part[p], status)) {
            json_decref(list);
            json_decref(results);
            return false;
        }
    }
    return clod_parts_write_summary(sim, list, how->name, results, warnings, incomplete,
                                    status);
}

json_t *clod_parts_flags(int64_t flags, const clod_parts_flag *words, size_t count)
{
    json_t *list = json_array();
    for (size_t k = 0; k < count; k++) {
        if ((flags & words[k].flag) != 0) {
            json_array_append_new(list, json_string(words[k].word));
        }
    }
    return list;
}

int clod_parts_finished(const clod_part *part, int count, clod_part *finished)
{
    int found = 0;
    for (int p = 0; p < count; p++) {
        if (part[p].ok) {
            finished[found++] = part[p];
        }
    }
    return found;
}

void clod_parts_tell_finished(const clod_job_shared *sim, int count, const char *table)
{
    char text[PATH_MAX + 256];
    if (sim->options->notice != NULL) {
        snprintf(text, sizeof text,
                 "what is known of the %d finished part%s is in %s/%s and summary.json", count,
                 count == 1 ? "" : "s", sim->directory, table);
        sim->options->notice(sim->options->context, text);
    }
}

static double total_wall_clock(const clod_part *part, int parts)
{
    double sum = 0.0;
    for (int p = 0; p < parts; p++) {
        sum += part[p].wall_clock;
    }
    return sum;
}

int clod_parts_headline(const clod_part *part, int parts, const char *title, const char *what,
                        char *text, size_t size)
{
    return snprintf(text, size,
                    "%s\n%zu grain%s, dt %.4g s, coordination %.2f, largest overlap at the "
                    "end of %s %.3g %% of a radius, %.0f s of wall-clock time%s\n\n",
                    title, part[0].grains, clod_plural((double)part[0].grains), part[0].dt,
                    part[0].coordination, what, 100.0 * part[0].max_overlap,
                    total_wall_clock(part, parts), parts > 1 ? " summed over the parts" : "");
}
