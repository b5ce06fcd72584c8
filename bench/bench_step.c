/**
 * @file bench_step.c
 * Whole steps on a periodic packing: grain-steps per second, memory, and what the bed was like
 * at the end, as one line of JSON.
 *
 *   bench_step PACKING.csv PACKING.box [--law NAME] [--steps N] [--warm N] [--threads N]
 *              [--simd SET] [--ledger] [--planes N] [--stages] [--peak]
 *              [--checkpoint FOLDER]
 *   bench_step --version
 *
 * Under mpirun all ranks step the bed. Then the most memory of each phase is told: dealing the bed,
 * steps, and gathering it on rank 0; every other rank tells its own in a line at the end. With that each
 * tells, of all steps behind `warm` but the last, its processor time outside of messages, how long it
 * waited in them and what it sent (rank_watch.h), and rank 0 the own rows of each.
 *
 * The packing and the laws (mepa, hertz, hertz-rolling) are those of bed.h. The clock runs over
 * `steps` after `warm` steps. --stages says what thread 0 spends in each stage, waiting for the
 * others included; not under mpirun. --planes has N counting planes across the bed, along x, y and z by
 * turns. --peak makes all lists anew in one more step, and before that, in
 * one process, the near list in another, behind the clock: the most memory that a run takes while it
 * steps. --checkpoint writes CHECKPOINTS of them into the folder after that, as a run does, and tells
 * the memory and the time of the last.
 */
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "base/memory.h"
#include "bed.h"
#include "clod/ranks.h"
#include "clod/version.h"
#include "output/checkpoint.h"
#include "rank_watch.h"
#include "resident.h"
#include "stages.h"
#include "step/crew_part.h"

#define TIME_STEP 1e-7 // s, for all programs: bench/peers
#define CHECKPOINTS 3  // from the third on two older ones are there to be looked at first

typedef struct options {
    const char *csv, *box, *law, *folder;
    int64_t steps, warm; ///< warm < 0: a tenth of the steps, and one
    clod_step_options step;
    bool ledger, stages, peak;
    int32_t planes;
} options;

typedef struct measured {
    double wall;      ///< s
    double processor; ///< s, of all threads of this process in it
    double stage[BENCH_STAGES];
    clod_energies energies;
    double contacts;
    int64_t rebuilds, rebuilds_warm; ///< in all, and before the clock ran
    double writing;                  ///< s, of the last checkpoint
    long rss_empty, rss_dealt, rss_stepped, rss_peak, rss_gathered, rss_written; ///< kB
} measured;

static const struct option OPTIONS[] = {
    {"law", required_argument, NULL, 'l'},
    {"steps", required_argument, NULL, 's'},
    {"warm", required_argument, NULL, 'w'},
    {"threads", required_argument, NULL, 't'},
    {"simd", required_argument, NULL, 'i'},
    {"ledger", no_argument, NULL, 'e'},
    {"planes", required_argument, NULL, 'n'},
    {"stages", no_argument, NULL, 'g'},
    {"peak", no_argument, NULL, 'p'},
    {"version", no_argument, NULL, 'v'},
    {"checkpoint", required_argument, NULL, 'c'},
    {0},
};

static void give_up(const char *text)
{
    fprintf(stderr, "bench_step: %s\n", text);
    exit(2);
}

static int64_t number(const char *text, int64_t least)
{
    char *end = NULL;
    const int64_t value = strtoll(text, &end, 10);
    if (*text == '\0' || *end != '\0' || value < least) {
        give_up("steps and threads are whole numbers from 1, warm from 0");
    }
    return value;
}

static options read_options(int argc, char **argv)
{
    options o = {.law = "mepa", .steps = 2000, .warm = -1, .step = {.threads = 1}};
    int key;
    while ((key = getopt_long(argc, argv, "", OPTIONS, NULL)) != -1) {
        switch (key) {
        case 'l':
            o.law = optarg;
            break;
        case 's':
            o.steps = number(optarg, 1);
            break;
        case 'w':
            o.warm = number(optarg, 0);
            break;
        case 't':
            o.step.threads = (int)number(optarg, 1);
            break;
        case 'i':
            o.step.simd = optarg;
            break;
        case 'e':
            o.ledger = true;
            break;
        case 'n':
            o.planes = (int32_t)number(optarg, 0);
            break;
        case 'g':
            o.stages = true;
            break;
        case 'p':
            o.peak = true;
            break;
        case 'c':
            o.folder = optarg;
            break;
        case 'v':
            puts(clod_version_text());
            exit(0);
        default:
            exit(2);
        }
    }
    if (argc - optind != 2 || o.planes > CLOD_PLANES) {
        give_up("usage: bench_step PACKING.csv PACKING.box [options], see bench/bench_step.c");
    }
    o.csv = argv[optind];
    o.box = argv[optind + 1];
    o.warm = o.warm < 0 ? o.steps / 10 + 1 : o.warm;
    return o;
}

/** Planes at even distances across the whole bed. */
static void add_planes(clod_state *state, int32_t count)
{
    const clod_domain *domain = &state->domain;
    state->planes.count = count;
    for (int32_t p = 0; p < count; p++) {
        clod_plane *plane = &state->planes.plane[p];
        const int axis = (int)(p % 3);
        const double share = (p + 0.5) / count;
        *plane = (clod_plane){.axis = axis, .sign = 1};
        memcpy(plane->region.low, domain->min, sizeof domain->min);
        memcpy(plane->region.high, domain->max, sizeof domain->max);
        plane->at = domain->min[axis] + share * (domain->max[axis] - domain->min[axis]);
    }
}

/** One step in which the near list is made anew, as if a wall had gone too far. */
static bool remake_near(clod_step *step, clod_status *status)
{
    const int64_t refreshes = step->refreshes;
    step->near.wall_skin = -1.0;
    return clod_step_advance(step, 1, status) &&
           (step->refreshes > refreshes ||
            clod_status_fail(status, CLOD_FAILED, "the near list was not made anew"));
}

/** One step in which all lists are made anew, on all ranks. */
static bool remake(clod_step *step, clod_status *status)
{
    const int64_t rebuilds = step->rebuilds;
    step->state->build_motion = INFINITY;
    return clod_step_advance(step, 1, status) &&
           (step->rebuilds > rebuilds ||
            clod_status_fail(status, CLOD_FAILED, "the lists were not made anew"));
}

/** Checkpoints as a job writes them. */
static bool write_checkpoints(const char *path, clod_step *step, double *seconds,
                              clod_status *status)
{
    clod_folder *folder = clod_folder_open(path, status);
    bool good = folder != NULL;
    for (int k = 0; good && k < CHECKPOINTS; k++) {
        const double begin = bench_now();
        clod_step_bed view;
        const clod_bed_source bed = clod_step_bed_source(step, &view);
        good =
            clod_checkpoint_write(folder, "restart", step->state, &bed, NULL, 0, NULL, status);
        *seconds = bench_now() - begin;
    }
    clod_folder_close(&folder);
    return good;
}

static double count_contacts(clod_step *step)
{
    size_t pairs, walls;
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(step, &reader);
    contacts.begin(contacts.context, &pairs, &walls);
    return (double)(pairs + walls);
}

/** On ranks each phase is measured by itself. */
static void forget_ranks(const clod_step *step)
{
    if (step->crew != NULL) {
        bench_resident_forget();
    }
}

static bool measure(const options *o, clod_step *step, measured *m, clod_status *status)
{
    if ((o->ledger && !clod_step_open_ledger(step, status)) ||
        !clod_step_advance(step, o->warm, status)) {
        return false;
    }
    forget_ranks(step);
    m->rebuilds_warm = step->rebuilds;
    const double worked = clod_clock_read(CLOCK_PROCESS_CPUTIME_ID), begin = bench_now();
    bool good = o->stages ? bench_stages_advance(step, o->steps, m->stage, status)
                          : clod_step_advance(step, o->steps, status);
    m->wall = bench_now() - begin;
    m->processor = clod_clock_read(CLOCK_PROCESS_CPUTIME_ID) - worked;
    m->rss_stepped = bench_resident_most();
    m->rebuilds = step->rebuilds;
    good = good && (!o->peak || ((step->crew != NULL || remake_near(step, status)) &&
                                 remake(step, status)));
    m->rss_peak = bench_resident_most();
    forget_ranks(step);
    good =
        good && (o->folder == NULL || write_checkpoints(o->folder, step, &m->writing, status));
    m->rss_written = bench_resident_most();
    forget_ranks(step);
    if (!good || !clod_step_see(step, status)) {
        return false;
    }
    m->rss_gathered = bench_resident_most();
    m->contacts = count_contacts(step);
    m->energies = clod_step_energies(step); // with scratch of its own
    return true;
}

/** Own rows of each rank, and what this one did. */
static void report_ranks(clod_step *step, const measured *m)
{
    if (step->crew == NULL) {
        return;
    }
    const clod_ranks *ranks = step->crew->ranks;
    size_t *own = clod_memory_alloc((size_t)ranks->size, sizeof *own);
    for (size_t g = 0; own != NULL && g < step->state->grains.count; g++) {
        const double *place = step->state->build_position[g];
        own[clod_partition_owner(&step->crew->spread.partition, place)]++;
    }
    printf("\"rank\": 0, \"own_rows\": [");
    for (int r = 0; own != NULL && r < ranks->size; r++) {
        printf("%s%zu", r > 0 ? ", " : "", own[r]);
    }
    clod_memory_free(own);
    const bench_rank_watched seen = bench_rank_seen();
    printf("], \"timed_rebuilds\": %lld, \"looks\": %lld, \"cuts\": %lld, ",
           (long long)(m->rebuilds - m->rebuilds_warm), (long long)ranks->evenness.looks,
           (long long)ranks->evenness.cuts);
    bench_rank_print(&seen);
    printf(", ");
}

static void report(const options *o, clod_step *step, const measured *m)
{
    const clod_state *state = step->state;
    const double grains = (double)state->grains.count;
    const double contacts = m->contacts;
    printf("{\"version\": \"%s\", \"law\": \"%s\", \"simd\": \"%s\", \"threads\": %d, ",
           clod_version_text(), o->law, step->kernel->name, step->threads);
    printf("\"grains\": %zu, \"contacts_per_grain\": %.4f, ", state->grains.count,
           contacts / grains);
    if (step->crew == NULL) { // else each rank has a list
        printf("\"near_per_contact\": %.4f, ",
               (double)step->near.pairs.count * CLOD_LANES / contacts);
    }
    printf("\"warm\": %lld, \"steps\": %lld, \"rebuilds\": %lld, \"refreshes\": %lld, ",
           (long long)o->warm, (long long)o->steps, (long long)m->rebuilds,
           (long long)step->refreshes);
    printf(
        "\"processor_s\": %.6g, \"seconds\": %.6g, \"grain_steps_per_s\": %.4g, \"ns_per_contact\": %.2f, ",
        m->processor, m->wall, grains * (double)o->steps / m->wall,
        1e9 * m->wall / ((double)o->steps * contacts));
    if (o->stages) {
        printf("\"ns_per_grain_step\": {");
        for (int k = 0; k < BENCH_STAGES; k++) {
            printf("%s\"%s\": %.3f", k > 0 ? ", " : "", bench_stage_name(k),
                   1e9 * m->stage[k] / (grains * (double)o->steps));
        }
        printf("}, ");
    }
    printf("\"kinetic_J\": %.17g, \"rotational_J\": %.17g, ", m->energies.translation,
           m->energies.rotation);
    if (o->folder != NULL) {
        printf("\"checkpoint_s\": %.4g, \"rss_written_kB\": %ld, ", m->writing, m->rss_written);
    }
    report_ranks(step, m);
    printf("\"ranks\": %d, \"rss_dealt_kB\": %ld, \"rss_gathered_kB\": %ld, ",
           clod_ranks_size(o->step.ranks), m->rss_dealt, m->rss_gathered);
    printf("\"rss_empty_kB\": %ld, \"rss_stepped_kB\": %ld, \"rss_peak_kB\": %ld}\n",
           m->rss_empty, m->rss_stepped, m->rss_peak);
}

/** Another rank than the first: what it takes, and at most. */
static void serve(clod_ranks *ranks)
{
    const long empty = bench_resident_most();
    clod_ranks_serve(ranks);
    const long most = bench_resident_most();
    const bench_rank_watched seen = bench_rank_seen();
    printf("{\"rank\": %d, \"rss_empty_kB\": %ld, \"rss_most_kB\": %ld, ",
           clod_ranks_number(ranks), empty, most);
    bench_rank_print(&seen);
    printf("}\n");
}

int main(int argc, char **argv)
{
    clod_status status = {0};
    clod_ranks *ranks = clod_ranks_open(&status);
    if (ranks == NULL) {
        give_up(status.text);
    }
    options o = read_options(argc, argv);
    if (clod_ranks_size(ranks) > 1) {
        bench_rank_watch(ranks, o.warm, o.steps - 1);
    }
    if (clod_ranks_number(ranks) > 0) {
        serve(ranks);
        clod_ranks_close(&ranks);
        return 0;
    }
    o.step.ranks = ranks;
    if (o.stages && clod_ranks_size(ranks) > 1) {
        give_up("--stages tells those of one process; leave it out under mpirun");
    }
    measured m = {.rss_empty = bench_resident_most()};
    clod_state state;
    clod_law law;
    clod_step step;
    if (!bench_bed_law(o.law, &law, &status) ||
        !bench_bed_read(o.csv, o.box, &state, &status)) {
        give_up(status.text);
    }
    state.dt = TIME_STEP;
    add_planes(&state, o.planes);
    const clod_laws laws = {.materials = 1, .count = 1, .law = &law};
    if (!clod_step_init(&step, &state, &laws, &o.step, &status)) {
        give_up(status.text);
    }
    m.rss_dealt = bench_resident_most();
    if (!measure(&o, &step, &m, &status)) {
        give_up(status.text);
    }
    report(&o, &step, &m);
    clod_step_fini(&step);
    clod_state_fini(&state);
    clod_ranks_close(&ranks);
    return 0;
}
