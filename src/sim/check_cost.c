#include <math.h>

#include "base/memory.h"
#include "output/folder.h"
#include "parallel/threads.h"
#include "setup/grains.h"
#include "sim/check_fields.h"
#include "sim/energy_series.h"
#include "sim/outputs.h"
#include "sim/testers.h"
#include "tester/limits.h"

#define NUMBER_BYTES 18.0 ///< of a number in a series
#define FREE_COLUMNS 4.0  ///< columns of the series of a free run, and of each wall of it
#define WALL_COLUMNS 11.0
#define PROGRAM_BYTES 22e6 ///< of the program with its libraries, and of a checkpoint's way
#define PICTURE_GRAIN 80.0 ///< bytes of a grain in a snapshot, compressed
#define PICTURE_CONTACT 75.0
#define PICTURE_FACET 13.0       ///< of a facet that stays where it is
#define PICTURE_FACET_MOVED 19.0 ///< of one that turns or moves
#define SHAPE_BYTES 700.0        ///< of a patch in one of its slots
#define READ_FACET 250.0         ///< bytes while a file is read (docs/meshes.md)
#define STORED_GRAIN 190.0       ///< bytes of a grain in a checkpoint
#define STORED_CONTACT 76.0
#define CONTACTS 3.0 ///< contacts for each grain
#define STREAM_SLOWER                                                                          \
    10.0                ///< a dense fast stream on walls, beside the slow bed that is measured
#define PART_PHASES 6.0 ///< of a part of a test at most, each with a snapshot at its end

/** Clock time of a batch: as many workers as there are parts and threads, threads shared. */
static double batch_clock(const clod_check_report *report, const clod_check_batch *parts)
{
    const int threads = report->threads;
    const int workers = parts->count < threads ? parts->count : threads;
    const int each = threads / workers;
    const double part = threads > 1 ? (double)(each - 1) / (threads - 1) : 0.0;
    const double rate = report->rate_one + part * (report->rate - report->rate_one);
    const double time = fmax(parts->time / workers, parts->longest);
    const double work = time / report->step * (double)report->grains * CLOD_CHECK_SAMPLE_EXCESS;
    return rate > 0.0 ? work / rate : 0.0;
}

double clod_check_slower(const clod_case *from)
{
    return clod_setup_grains_coming(from) > 0 ? STREAM_SLOWER : 1.0;
}

static clod_check_batch stages(const clod_case *from)
{
    clod_check_batch all = {1, 0.0, 0.0};
    for (size_t s = 0; s < from->stage_count; s++) {
        all.time += from->stages[s].duration;
    }
    all.longest = all.time;
    return all;
}

int clod_check_free_batches(const clod_case *from, bool most,
                            clod_check_batch all[CLOD_CHECK_BATCHES])
{
    (void)most;
    all[0] = stages(from);
    return 1;
}

static void plan_run(const clod_case *from, clod_check_report *report)
{
    for (int most = 0; most < 2; most++) {
        clod_check_batch all[CLOD_CHECK_BATCHES];
        const int batches = clod_testers_of(from)->batches(from, most != 0, all);
        int count = 0;
        double time = 0.0;
        double clock = 0.0;
        for (int b = 0; b < batches; b++) {
            count = all[b].count > count ? all[b].count : count;
            time += all[b].time;
            clock += batch_clock(report, &all[b]);
        }
        report->side_by_side = count < report->threads ? count : report->threads;
        *(most != 0 ? &report->time_most : &report->time_likely) = time;
        *(most != 0 ? &report->steps_most : &report->steps_likely) = time / report->step;
        *(most != 0 ? &report->clock_most : &report->clock_likely) =
            most != 0 ? clock * clod_check_slower(from) : clock;
    }
}

/** Rows and snapshots: of a free run those that it writes, of a test at most. */
static void plan_outputs(const clod_case *from, double parts, clod_check_report *report)
{
    if (clod_case_tester(from) == NULL) {
        const clod_outputs all = clod_outputs_of(from, report->step);
        report->rows_most = (double)all.rows;
        report->snapshots_most = (double)all.snapshots;
        return;
    }
    const double pictures = from->output.snapshot_interval;
    const int64_t steps = (int64_t)ceil(report->steps_most);
    report->rows_most = report->steps_most / CLOD_LIMITS_COARSE_STEPS;
    report->snapshots_most =
        PART_PHASES * parts + (double)clod_outputs_count(pictures, report->step, steps);
}

static bool turns(const clod_wall *wall)
{
    return wall->spin != 0.0 || wall->load != CLOD_LOAD_NONE ||
           wall->oscillation.frequency > 0.0;
}

/** Bytes of facets in a snapshot of the walls. */
static double picture_of_facets(const clod_check_subject *subject)
{
    double bytes = 0.0;
    for (int32_t w = 0; w < subject->state.walls.count; w++) {
        const clod_wall *wall = &subject->state.walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            const clod_shape *shape = &wall->shapes[s];
            if (shape->surface != NULL && shape->patch == 0 && shape->slot == 0) {
                bytes += (double)shape->surface->facet_count *
                         (turns(wall) ? PICTURE_FACET_MOVED : PICTURE_FACET);
            }
        }
    }
    return bytes;
}

static void plan_disk(const clod_check_subject *subject, clod_check_report *report)
{
    const clod_case *from = subject->from;
    double parts = 1.0;
    double columns = FREE_COLUMNS + WALL_COLUMNS * (double)subject->state.walls.count;
    if (clod_case_tester(from) != NULL) {
        clod_check_batch all[CLOD_CHECK_BATCHES];
        const clod_tester_row *tester = clod_testers_of(from);
        const int batches = tester->batches(from, true, all);
        parts = 0.0;
        for (int b = 0; b < batches; b++) {
            parts += all[b].count;
        }
        columns = (double)tester->first->procedure.column_count;
    }
    plan_outputs(from, parts, report);
    const clod_check_fields_cost fields =
        clod_check_fields_of(from, &(clod_check_fields_run){.grains = (double)report->grains,
                                                            .step = report->step,
                                                            .duration = report->time_most,
                                                            .pictures = report->snapshots_most,
                                                            .rows = report->rows_most,
                                                            .parts = parts,
                                                            .beside = report->side_by_side});
    report->fields_clock = fields.clock;
    report->fields_memory = fields.memory;
    report->clock_likely += fields.clock;
    report->clock_most += fields.clock;
    columns += fields.columns;
    const double grains = (double)report->grains;
    const double contacts = from->output.contacts ? CONTACTS * PICTURE_CONTACT : 0.0;
    columns += from->output.energy ? CLOD_ENERGY_SERIES_COLUMNS : 0.0;
    report->disk_series = report->rows_most * columns * NUMBER_BYTES;
    report->disk_snapshots = report->snapshots_most * (grains * (PICTURE_GRAIN + contacts) +
                                                       picture_of_facets(subject)) +
                             fields.disk;
    // two of each part are kept, and a third is there while it is written
    report->disk_checkpoints =
        3.0 * parts * (grains * (STORED_GRAIN + CONTACTS * STORED_CONTACT) + fields.stored);
    report->disk = report->disk_series + report->disk_snapshots + report->disk_checkpoints;
}

static bool find_space(const clod_check_subject *subject, clod_check_report *report,
                       clod_status *status)
{
    const char *given = subject->options->directory;
    char *standard = given == NULL ? clod_folder_default(subject->from->path, status) : NULL;
    const char *folder = given != NULL ? given : standard;
    const bool good = folder != NULL && clod_folder_space(folder, &report->disk_free, status);
    clod_memory_free(standard);
    return good;
}

/** Memory of one part of a run when it makes its lists anew; a checkpoint takes no more. */
static double memory_of(const clod_check_bytes *each, double grains)
{
    const bool large = grains * each->contacts >= CLOD_MEMORY_LARGE;
    const double histories =
        large ? fmax(each->contacts, each->blocks) : each->contacts + each->blocks;
    return grains * (each->other + each->scratch + histories);
}

/** Facets of all walls, and what they take. A mesh comes once, at its first patch. */
static void count_facets(const clod_check_subject *subject, clod_check_report *report)
{
    for (int32_t w = 0; w < subject->state.walls.count; w++) {
        const clod_wall *wall = &subject->state.walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            const clod_shape *shape = &wall->shapes[s];
            if (shape->surface == NULL) {
                continue;
            }
            report->memory_facets += SHAPE_BYTES;
            if (shape->patch == 0 && shape->slot == 0) {
                report->facets += shape->surface->facet_count;
                report->patches += shape->surface->patch_count;
                report->memory_facets += (double)clod_surface_bytes(shape->surface);
            }
        }
    }
}

bool clod_check_cost(const clod_check_subject *subject, clod_check_report *report,
                     clod_status *status)
{
    clod_check_bytes bytes = {0};
    report->processors = clod_threads_available();
    report->threads = clod_threads_take(subject->options->threads);
    if (subject->options->threads == 0 && subject->options->ranks > 0) {
        report->threads = 1; // of each
    } else if (subject->options->threads == 0 && clod_case_tester(subject->from) == NULL) {
        report->threads = clod_threads_worth(report->threads, (size_t)report->grains);
    }
    if (!clod_check_rate(subject, report, &bytes, status)) {
        return false;
    }
    plan_run(subject->from, report);
    count_facets(subject, report);
    plan_disk(subject, report);
    if (report->rate > 0.0) {
        // files are read before there are grains
        report->memory = fmax(memory_of(&bytes, (double)report->grains) * report->side_by_side +
                                  report->memory_facets + report->fields_memory,
                              READ_FACET * (double)report->facets) +
                         PROGRAM_BYTES;
    }
    clod_check_ranks_look(subject, report);
    return find_space(subject, report, status);
}
