#include <math.h>
#include <time.h>

#include "base/memory.h"
#include "base/random.h"
#include "output/folder.h"
#include "parallel/threads.h"
#include "sim/check.h"
#include "sim/energy_series.h"
#include "step/step.h"
#include "tester/limits.h"

// The packing on which the step is timed: a cubic lattice, six contacts for each grain as in a
// dense bed, pressed to the overlap of the target stress and stirred a little.
#define SAMPLE_SIDE_MIN 6 ///< grains along an edge
#define SAMPLE_SIDE_MAX 32
#define SAMPLE_SPEED 3e-3 ///< m/s at most along each axis, as between neighbours in slow shear
#define SAMPLE_WARM_UP 20 ///< steps
#define SAMPLE_CHUNK 20   ///< steps between two looks at the clock
#define SAMPLE_TIME 0.05  ///< s on the clock, of one measurement
#define SAMPLE_TIMES 4    ///< measurements; the best counts, other work on the machine does not
#define SAMPLE_EXCESS 1.3 ///< the lattice is faster than a random packing between walls

// Duration of the phases of a ring shear test, besides preshear and shear: what copper ore
// needs; their limits are those of the procedure (tester/limits.h).
#define FILL_LIKELY 0.2     ///< s, with the lid's way down
#define LOWER_MOST 6e-3     ///< m of the lid until it carries
#define LOAD_LIKELY 0.06    ///< s, to consolidate or to reduce the load
#define REVERSE_LIKELY 2e-4 ///< m
#define PRESHEAR_LIKELY 5.0 ///< times the least displacement
#define PEAK_LIKELY 4e-3    ///< m of shear
#define CRUSH_LIKELY 0.03   ///< strain at the peak of a uniaxial test
#define ROW_COLUMNS 11.0

#define NUMBER_BYTES 18.0 ///< of a number in a series
#define FREE_COLUMNS 4.0  ///< columns of the series of a free run, and of each wall of it
#define WALL_COLUMNS 11.0
#define PICTURE_GRAIN 80.0 ///< bytes of a grain in a snapshot, compressed
#define PICTURE_CONTACT 75.0
#define STORED_GRAIN 190.0 ///< bytes of a grain in a checkpoint
#define STORED_CONTACT 76.0
#define CONTACTS 3.0 ///< contacts for each grain

#define BATCHES_MAX 3

/** What the parts of a run ask for; parts of one batch run side by side. */
typedef struct batch {
    int count;
    double time, longest; ///< s simulated: sum over the parts, and of the longest
} batch;

static double clock_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool add_sample_grain(const clod_check_subject *subject, const clod_check_report *report,
                             int side, int number, clod_state *state, clod_status *status)
{
    const double spacing = 2.0 * report->radius_mean - report->overlap;
    const double density = subject->from->materials[subject->material].density;
    const int cell[3] = {number % side, number / side % side, number / (side * side)};
    double place[4] = {0.0, 0.0, 0.0, report->radius_mean};
    double speed[3];
    for (int a = 0; a < 3; a++) {
        const double u =
            clod_random_uniform(1, CLOD_RANDOM_VELOCITY, (uint64_t)number, (uint64_t)a);
        place[a] = (0.5 + cell[a]) * spacing;
        speed[a] = (2.0 * u - 1.0) * SAMPLE_SPEED;
    }
    return clod_grains_add(&state->grains, place, speed, (double[3]){0.0}, density,
                           (uint16_t)subject->material, (uint64_t)number + 1, status);
}

static bool make_sample(const clod_check_subject *subject, const clod_check_report *report,
                        clod_state *state, clod_status *status)
{
    const double edge = round(cbrt((double)report->grains));
    const int side = (int)fmin(fmax(edge, SAMPLE_SIDE_MIN), SAMPLE_SIDE_MAX);
    const double spacing = 2.0 * report->radius_mean - report->overlap;
    *state = (clod_state){
        .dt = fmin(report->step, report->automatic), .adhesion = 1.0, .build_motion = -1.0};
    for (int a = 0; a < 3; a++) {
        state->domain.max[a] = side * spacing;
        state->domain.periodic[a] = true;
    }
    bool good = true;
    for (int n = 0; good && n < side * side * side; n++) {
        good = add_sample_grain(subject, report, side, n, state, status);
    }
    return good;
}

/** Bytes of a grain of the sample. */
typedef struct grain_bytes {
    double contacts, blocks; ///< histories: a large bed holds them once, a small one in both
    double scratch;          ///< given back in a large bed (docs/adr/0016)
    double other;
} grain_bytes;

/** What state and step take; room that is never used takes none. */
static grain_bytes count_bytes(const clod_step *step)
{
    const clod_neighbour *near = &step->neighbour;
    const clod_near *list = &step->near;
    const clod_state *state = step->state;
    const double grains = (double)state->grains.capacity;
    const double rows = grains * (3 * 4 + 8 + 1 + 4) * sizeof(double) + 2 * grains;
    const double contacts = (double)state->contact_count * (double)sizeof(clod_contact);
    const double candidates =
        (double)near->pairs.count * sizeof(clod_partner) + grains * sizeof(uint32_t);
    const double sorting = 2.0 * (double)near->sort_capacity * sizeof(clod_sort_item) +
                           (double)near->grain_capacity * 3 * sizeof(int32_t);
    const double blocks = (double)list->pairs.count * (double)sizeof(clod_contact_block) +
                          (double)list->between.share_capacity * 8 * sizeof(double);
    const double ledger = list->ledger
                              ? grains * (8 + 4) * sizeof(double) +
                                    (double)list->pairs.count * (double)sizeof(clod_spent_block)
                              : 0.0;
    const double count = (double)state->grains.count;
    return (grain_bytes){contacts / count, blocks / count, sorting / count,
                         (rows + candidates + ledger) / count};
}

/** Rate of the step on a copy of the sample [grain-steps/s]. */
static bool time_step(const clod_state *sample, const clod_laws *laws,
                      const clod_step_options *options, bool energy, double *rate,
                      grain_bytes *bytes, const char **simd, clod_status *status)
{
    clod_state state = {0};
    clod_step step;
    if (!clod_state_copy(&state, sample, status) ||
        !clod_step_init(&step, &state, laws, options, status)) {
        clod_state_fini(&state);
        return false;
    }
    bool good = !energy || clod_step_open_ledger(&step, status);
    good = good && clod_step_advance(&step, SAMPLE_WARM_UP, status);
    *rate = 0.0;
    for (int t = 0; good && t < SAMPLE_TIMES; t++) {
        const double begin = clock_now();
        double steps = 0.0;
        double spent = 0.0;
        while (good && spent < SAMPLE_TIME) {
            good = clod_step_advance(&step, SAMPLE_CHUNK, status);
            steps += SAMPLE_CHUNK;
            spent = clock_now() - begin;
        }
        *rate = fmax(*rate, steps * (double)state.grains.count / spent);
    }
    good = good && clod_step_export(&step, status);
    if (good) {
        *bytes = count_bytes(&step);
        *simd = step.kernel->name;
    }
    clod_step_fini(&step);
    clod_state_fini(&state);
    return good;
}

static bool measure_rate(const clod_check_subject *subject, clod_check_report *report,
                         grain_bytes *bytes, clod_status *status)
{
    clod_state sample;
    clod_laws laws;
    if (!clod_laws_init(&laws, subject->from, status)) {
        return false;
    }
    bool good = make_sample(subject, report, &sample, status);
    report->sample_grains = sample.grains.count;
    clod_step_options options = {.threads = 1, .simd = subject->options->simd};
    const bool energy = subject->from->output.energy;
    good = good && time_step(&sample, &laws, &options, energy, &report->rate_one, bytes,
                             &report->simd, status);
    report->rate = report->rate_one;
    if (good && report->threads > 1) {
        options.threads = report->threads;
        good = time_step(&sample, &laws, &options, energy, &report->rate, bytes, &report->simd,
                         status);
    }
    clod_state_fini(&sample);
    clod_laws_fini(&laws);
    return good;
}

/** Clock time of a batch: as many workers as there are parts and threads, threads shared. */
static double batch_clock(const clod_check_report *report, const batch *parts)
{
    const int threads = report->threads;
    const int workers = parts->count < threads ? parts->count : threads;
    const int each = threads / workers;
    const double part = threads > 1 ? (double)(each - 1) / (threads - 1) : 0.0;
    const double rate = report->rate_one + part * (report->rate - report->rate_one);
    const double time = fmax(parts->time / workers, parts->longest);
    return time / report->step * (double)report->grains * SAMPLE_EXCESS / rate;
}

/** Preshears; `before` is what the tester does between consolidation and preshear [s]. */
static batch preparations(const clod_case_programme *test, double before, bool most)
{
    const double least = (double)test->steady_blocks * test->block_displacement;
    const double shear =
        most ? test->preshear_max : fmin(PRESHEAR_LIKELY * least, test->preshear_max);
    const double time = (most ? CLOD_LIMITS_FILL_TIME + LOWER_MOST / CLOD_LIMITS_LOWER_SPEED +
                                    CLOD_LIMITS_SETTLE_TIME
                              : FILL_LIKELY + LOAD_LIKELY) +
                        before + shear / test->speed;
    return (batch){(int)test->seeds, (double)test->seeds * time, time};
}

static batch reversals(const clod_case_programme *test, bool most)
{
    const double time = (most ? CLOD_LIMITS_REVERSE_MAX : REVERSE_LIKELY) /
                        (CLOD_LIMITS_REVERSE_FRACTION * test->speed);
    return (batch){(int)test->seeds, (double)test->seeds * time, time};
}

static batch points(const clod_case_programme *test, bool most)
{
    batch all = {(int)(test->seeds * (int64_t)test->shear_stress_count), 0.0, 0.0};
    const double peak = fmin(PEAK_LIKELY + test->beyond_peak, test->shear_max);
    for (size_t s = 0; s < test->shear_stress_count; s++) {
        const double speed =
            test->speed * sqrt(test->shear_stresses[s] / test->preshear_stress);
        const double time = (most ? CLOD_LIMITS_SETTLE_TIME : LOAD_LIKELY) +
                            (most ? test->shear_max : peak) / speed;
        all.time += (double)test->seeds * time;
        all.longest = fmax(all.longest, time);
    }
    return all;
}

/** Time in which the lid of a Jenike cell is twisted: to each side and back, at its edge. */
static double twisting(const clod_case_jenike *test)
{
    const double way = 4.0 * (double)test->twists * test->twist_angle * 0.5 * test->diameter;
    return test->twists > 0 ? way / test->programme.speed : 0.0;
}

static batch filling(bool most)
{
    const double time = most ? CLOD_LIMITS_FILL_TIME : FILL_LIKELY;
    return (batch){1, time, time};
}

/** Consolidations of a uniaxial test, each crushed. */
static batch crushings(const clod_case_uniaxial *test, bool most)
{
    const double strain =
        most ? test->crush_max : fmin(CRUSH_LIKELY + test->beyond_peak, test->crush_max);
    const double rests = 2.0 * (most ? CLOD_LIMITS_SETTLE_TIME : LOAD_LIKELY);
    const double time = (most ? test->height / CLOD_LIMITS_LOWER_SPEED : 0.0) + rests +
                        strain * test->height / test->speed;
    const int count = (int)test->consolidation_stress_count;
    return (batch){count, count * time, time};
}

static batch stages(const clod_case *from)
{
    batch all = {1, 0.0, 0.0};
    for (size_t s = 0; s < from->stage_count; s++) {
        all.time += from->stages[s].duration;
    }
    all.longest = all.time;
    return all;
}

/** The batches of a run, each after the one before; returns how many. */
static int plan_parts(const clod_case *from, bool most, batch all[BATCHES_MAX])
{
    const clod_case_programme *shear = clod_case_shear(from);
    if (shear != NULL) {
        all[0] = preparations(shear, twisting(&from->jenike), most);
        all[1] = reversals(shear, most);
        all[2] = points(shear, most);
        return 3;
    }
    if (from->uniaxial.present) {
        all[0] = filling(most);
        all[1] = crushings(&from->uniaxial, most);
        return 2;
    }
    all[0] = stages(from);
    return 1;
}

static void plan_run(const clod_case *from, clod_check_report *report)
{
    for (int most = 0; most < 2; most++) {
        batch all[BATCHES_MAX];
        const int batches = plan_parts(from, most != 0, all);
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
        *(most != 0 ? &report->clock_most : &report->clock_likely) = clock;
    }
}

static void plan_disk(const clod_check_subject *subject, clod_check_report *report)
{
    const clod_case *from = subject->from;
    double parts = 1.0;
    double rows = report->time_most / from->output.series_interval;
    double columns = FREE_COLUMNS + WALL_COLUMNS * (double)subject->state.walls.count;
    double pictures = 1.0;
    if (clod_case_tester(from) != NULL) {
        batch all[BATCHES_MAX];
        const int batches = plan_parts(from, true, all);
        parts = 0.0;
        for (int b = 0; b < batches; b++) {
            parts += all[b].count;
        }
        rows = report->steps_most / CLOD_LIMITS_COARSE_STEPS;
        columns = ROW_COLUMNS;
        pictures = parts;
    }
    if (from->output.snapshot_interval > 0.0) {
        pictures += report->time_most / from->output.snapshot_interval;
    }
    const double grains = (double)report->grains;
    const double contacts = from->output.contacts ? CONTACTS * PICTURE_CONTACT : 0.0;
    columns += from->output.energy ? CLOD_ENERGY_SERIES_COLUMNS : 0.0;
    report->disk_series = rows * columns * NUMBER_BYTES;
    report->disk_snapshots = pictures * grains * (PICTURE_GRAIN + contacts);
    // two of each part are kept, and a third is there while it is written
    report->disk_checkpoints =
        3.0 * parts * grains * (STORED_GRAIN + CONTACTS * STORED_CONTACT);
    report->disk = report->disk_series + report->disk_snapshots + report->disk_checkpoints;
}

static bool find_space(const clod_check_subject *subject, clod_check_report *report,
                       clod_status *status)
{
    char *folder = subject->options->directory != NULL
                       ? clod_memory_text(subject->options->directory)
                       : clod_folder_default(subject->from->path);
    if (folder == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the name of a folder");
    }
    const bool good = clod_folder_space(folder, &report->disk_free, status);
    clod_memory_free(folder);
    return good;
}

/** Memory of one part of a run while it writes a checkpoint: two images of the file. */
static double memory_of(const grain_bytes *each, double grains)
{
    const double image = grains * (STORED_GRAIN + CONTACTS * STORED_CONTACT);
    const bool large = grains * each->contacts >= CLOD_MEMORY_LARGE;
    const double histories = large ? fmax(each->contacts, each->blocks)
                                   : each->contacts + each->blocks + each->scratch;
    return grains * (each->other + histories) + 2.0 * image;
}

bool clod_check_cost(const clod_check_subject *subject, clod_check_report *report,
                     clod_status *status)
{
    grain_bytes bytes = {0};
    const int threads = subject->options->threads;
    report->processors = clod_threads_available();
    report->threads = threads > 0 ? threads : report->processors;
    if (!measure_rate(subject, report, &bytes, status)) {
        return false;
    }
    plan_run(subject->from, report);
    plan_disk(subject, report);
    report->memory = memory_of(&bytes, (double)report->grains) * report->side_by_side;
    return find_space(subject, report, status);
}
