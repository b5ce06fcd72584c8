#include "sim/ring_run.h"

#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "measure/contacts.h"
#include "parallel/threads.h"
#include "setup/ring_cell.h"
#include "sim/ring_report.h"

/** A stage of the test: parts that may run side by side. */
typedef struct ring_batch {
    const clod_sim *sim;
    clod_ring_part *part; ///< [count]
    int count;
    int threads;        ///< of each part
    atomic_bool failed; ///< a part has: no further one is begun
} ring_batch;

static int64_t ring_plan(const void *data, const void *context, const clod_state *state)
{
    (void)context;
    return clod_ring_shear_plan(data, state);
}

static bool ring_sample(void *data, const void *context, clod_state *state, double *row)
{
    (void)context;
    return clod_ring_shear_sample(data, state, row);
}

static const char *ring_phase(const void *data, const void *context)
{
    (void)context;
    const clod_ring_shear *self = data;
    return clod_ring_shear_phase_name((clod_ring_shear_phase)self->phase);
}

static double ring_fraction(const void *data, const void *context)
{
    (void)context;
    return clod_ring_shear_progress(data);
}

static bool ring_trouble(const void *data, char *text, size_t size)
{
    return clod_ring_shear_trouble(data, text, size);
}

/** Names: `preshear`, `point-1`; with several seeds `seed-3-preshear`. */
static void name_part(const clod_case *from, int64_t seed, int64_t point, char name[48])
{
    char prefix[24] = "";
    if (from->ring_shear.seeds > 1) {
        snprintf(prefix, sizeof prefix, "seed-%lld-", (long long)seed);
    }
    if (point < 0) {
        snprintf(name, 48, "%spreshear", prefix);
    } else {
        snprintf(name, 48, "%spoint-%lld", prefix, (long long)point + 1);
    }
}

static void init_job(const ring_batch *batch, clod_ring_part *part, clod_job *job)
{
    *job = (clod_job){.sim = batch->sim, .threads = batch->threads};
    memcpy(job->name, part->name, sizeof job->name);
    job->procedure = (clod_procedure){.data = &part->test,
                                      .size = sizeof part->test,
                                      .columns = clod_ring_shear_columns,
                                      .column_count = CLOD_RING_SHEAR_COLUMNS,
                                      .plan = ring_plan,
                                      .sample = ring_sample,
                                      .phase = ring_phase,
                                      .fraction = ring_fraction,
                                      .trouble = ring_trouble};
}

/** Take over the presheared state of the point's seed. */
static bool branch(const ring_batch *batch, clod_ring_part *part, clod_job *job,
                   clod_status *status)
{
    const clod_case_ring_shear *cell = &batch->sim->from->ring_shear;
    char prepared[48];
    name_part(batch->sim->from, part->seed, -1, prepared);
    if (!clod_job_begin_from(job, prepared, status)) {
        return false;
    }
    clod_ring_shear_branch(&part->test, cell->shear_stresses[part->point], &job->state);
    return true;
}

static bool begin(const ring_batch *batch, clod_ring_part *part, clod_job *job,
                  clod_status *status)
{
    if (part->point >= 0) {
        return branch(batch, part, job, status);
    }
    clod_ring_shear_begin(&part->test, batch->sim->from, &job->state);
    return true;
}

static void note_result(const clod_job *job, clod_ring_part *part)
{
    const clod_measure_contacts bed = clod_measure_contacts_of(&job->state);
    part->steps = job->state.step;
    part->dt = job->state.dt;
    part->wall_clock = job->memory.wall_clock;
    memcpy(part->version, job->memory.version, sizeof part->version);
    part->grains = job->state.grains.count;
    part->coordination = bed.coordination;
    part->max_overlap = bed.max_overlap;
    part->mean_overlap = bed.mean_overlap;
}

/** Whether a part may begin: not after a signal, nor when another part has failed. */
static bool may_begin(ring_batch *batch, clod_ring_part *part)
{
    const clod_run_options *options = batch->sim->options;
    const bool stop = options->stop != NULL && atomic_load(options->stop) != 0;
    if (stop || atomic_load(&batch->failed)) {
        return clod_status_fail(&part->status, CLOD_INTERRUPTED,
                                "%s was not begun; the same command goes on from here",
                                part->name);
    }
    return true;
}

static void run_part(void *context, int number)
{
    ring_batch *batch = context;
    clod_ring_part *part = &batch->part[number];
    if (!may_begin(batch, part)) {
        return;
    }
    clod_job job;
    init_job(batch, part, &job);
    part->ok = clod_setup_ring_cell(batch->sim->from, part->seed, &job.state, &part->status) &&
               clod_job_resume(&job, &part->status) &&
               (job.resumed || begin(batch, part, &job, &part->status)) &&
               clod_job_run(&job, &part->status);
    if (part->ok) {
        note_result(&job, part);
    } else if (part->status.code != CLOD_INTERRUPTED) {
        atomic_store(&batch->failed, true);
    }
    clod_job_fini(&job);
}

/** Run a batch; the first part that failed gives the status, an interruption last. */
static bool run_batch(ring_batch *batch, clod_status *status)
{
    const int given = batch->sim->options->threads;
    const int threads = given > 0 ? given : clod_threads_available();
    const int workers = batch->count < threads ? batch->count : threads;
    batch->threads = threads / workers > 0 ? threads / workers : 1;
    clod_threads_run(batch->count, workers, run_part, batch);
    bool ok = true;
    for (int p = 0; p < batch->count; p++) {
        const clod_ring_part *part = &batch->part[p];
        if (!part->ok && (ok || status->code == CLOD_INTERRUPTED)) {
            *status = part->status;
            ok = false;
        }
    }
    return ok;
}

static clod_ring_part *make_parts(const clod_case *from, int *preparations, int *points)
{
    const int seeds = (int)from->ring_shear.seeds;
    const int per_seed = (int)from->ring_shear.shear_stress_count;
    clod_ring_part *part =
        clod_memory_alloc((size_t)seeds * (size_t)(1 + per_seed), sizeof *part);
    *preparations = seeds;
    *points = seeds * per_seed;
    for (int k = 0; part != NULL && k < seeds * (1 + per_seed); k++) {
        const int point = k < seeds ? -1 : (k - seeds) % per_seed;
        part[k].seed = from->seed + (k < seeds ? k : (k - seeds) / per_seed);
        part[k].point = point;
        name_part(from, part[k].seed, point, part[k].name);
    }
    return part;
}

bool clod_ring_run(const clod_sim *sim, char **report, clod_status *status)
{
    int preparations;
    int points;
    clod_ring_part *part = make_parts(sim->from, &preparations, &points);
    if (part == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the parts of the test");
    }
    ring_batch first = {.sim = sim, .part = part, .count = preparations};
    ring_batch second = {.sim = sim, .part = part + preparations, .count = points};
    bool ok = run_batch(&first, status);
    ok = ok && run_batch(&second, status) &&
         clod_ring_report(sim, part, preparations, points, report, status);
    clod_memory_free(part);
    return ok;
}
