// What ranks would cost this case, from the closed form of check_ranks.c.

#include <math.h>

#include "base/memory.h"
#include "base/plural.h"
#include "sim/check_ranks.h"
#include "sim/check_testers.h"
#include "sim/group.h"
#include "sim/testers.h"

#define PROGRAM_BYTES 35e6 ///< rank 0 of 100 grains on 2 and 4 ranks, 2026-11-26: 35 and 37
#define SOLID_FRACTION 0.6 ///< of a settled bed
#define MICRO 1e6

/** Two digits: the model has no more. */
static double two_digits(double x)
{
    if (!(x > 0.0) || !isfinite(x)) {
        return x;
    }
    const double unit = pow(10.0, floor(log10(x)) - 1.0);
    return round(x / unit) * unit;
}

static double region_volume(const clod_case_region *region)
{
    if (region->kind == CLOD_REGION_BOX) {
        return (region->max[0] - region->min[0]) * (region->max[1] - region->min[1]) *
               (region->max[2] - region->min[2]);
    }
    return M_PI * region->height *
           (region->outer_radius * region->outer_radius -
            region->inner_radius * region->inner_radius);
}

/** How the bed begins; groups are taken to be as dense as all are together. */
static clod_check_ranks_start start_of(const clod_case *from, const clod_check_report *report)
{
    const bool tester = clod_case_tester(from) != NULL;
    clod_check_ranks_start start = {.whole = tester, .gathered = tester};
    double room = 0.0;
    for (size_t g = 0; g < from->grains_count; g++) {
        start.whole = start.whole || from->grains[g].file != NULL;
        room += from->grains[g].comes ? 0.0 : region_volume(&from->grains[g].region);
    }
    if (!start.whole && room > 0.0) {
        start.made = (double)report->grains;
        start.solid = report->solid_volume / room;
    }
    return start;
}

/** Each part of a batch on the ranks of its group; the most groups say what a rank has. */
static double batch_clock(const clod_check_batch *parts, const clod_check_report *report,
                          const clod_check_ranks_machine *machine, clod_check_ranks_bed *bed,
                          int *groups)
{
    *groups = clod_group_best(report->of_ranks.ranks, parts->count);
    bed->ranks = report->of_ranks.ranks / *groups;
    const int turns = (parts->count + *groups - 1) / *groups;
    const double time = fmax(parts->time * turns / parts->count, parts->longest);
    return time / report->step * clod_check_ranks_step(bed, machine);
}

static void find_time(const clod_case *from, const clod_check_ranks_machine *machine,
                      clod_check_report *report, clod_check_ranks_bed *bed)
{
    clod_check_ranks *told = &report->of_ranks;
    for (int most = 0; most < 2; most++) {
        clod_check_batch all[CLOD_CHECK_BATCHES];
        const int batches = clod_testers_of(from)->batches(from, most != 0, all);
        double clock = 0.0;
        for (int b = 0; b < batches; b++) {
            int groups;
            clock += batch_clock(&all[b], report, machine, bed, &groups);
            told->groups = groups > told->groups ? groups : told->groups;
        }
        bed->ranks = told->ranks / told->groups;
        clock *= most != 0 ? clod_check_slower(from) : 1.0;
        clock = two_digits(clock + report->fields_clock / bed->ranks);
        *(most != 0 ? &told->clock_most : &told->clock_likely) = clock;
    }
    told->step = two_digits(clod_check_ranks_step(bed, machine));
}

static void find_memory(const clod_check_ranks_bed *bed, const clod_check_ranks_start *start,
                        clod_check_report *report)
{
    clod_check_ranks *told = &report->of_ranks;
    const double each = PROGRAM_BYTES + report->memory_facets + report->fields_memory;
    clod_check_ranks_memory memory = clod_check_ranks_memory_of(bed, start);
    const double first = told->groups;
    const double others = told->ranks - first;
    if (bed->ranks == 1) { // nothing is dealt
        const double beds = report->memory - each;
        memory.begin_0 = memory.steps_0 = fmax(beds, 0.0) / report->side_by_side;
        memory.begin = memory.steps = 0.0;
    }
    told->all =
        two_digits(told->ranks * each + fmax(first * memory.begin_0 + others * memory.begin,
                                             first * memory.steps_0 + others * memory.steps));
    told->begin_0 = two_digits(memory.begin_0 + each);
    told->steps_0 = two_digits(memory.steps_0 + each);
    if (others > 0.0) {
        told->begin = two_digits(memory.begin + each);
        told->steps = two_digits(memory.steps + each);
    }
    told->machine = clod_memory_machine();
}

void clod_check_ranks_look(const clod_check_subject *subject, clod_check_report *report)
{
    clod_check_ranks *told = &report->of_ranks;
    if (subject->options->ranks == 0 || !(report->rate > 0.0)) {
        return;
    }
    const double grains = (double)report->grains;
    clod_check_ranks_bed bed = {grains, subject->options->ranks,
                                clod_check_ranks_layers(report->radius_mean, report->radius_max,
                                                        report->solid_volume / grains,
                                                        SOLID_FRACTION)};
    told->ranks = bed.ranks;
    const int node = report->processors / report->threads;
    told->node = node > 1 ? node : 1;
    const clod_check_ranks_machine machine = {CLOD_CHECK_SAMPLE_EXCESS / report->rate,
                                              CLOD_CHECK_SAMPLE_EXCESS / report->rate_one,
                                              told->node};
    find_time(subject->from, &machine, report, &bed);
    const clod_check_ranks_share share = clod_check_ranks_share_of(&bed);
    told->own = share.own;
    told->ghosts = two_digits(share.ghosts);
    const clod_check_ranks_start start = start_of(subject->from, report);
    if (start.made > 0.0) {
        const double bytes = report->disk_checkpoints / 3.0; // two are kept, one is written
        told->making = two_digits(clod_check_ranks_making(&start));
        told->writing = two_digits(clod_check_ranks_writing(&bed, bytes));
    }
    find_memory(&bed, &start, report);
}

void clod_check_ranks_warn(clod_check_report *r)
{
    const clod_check_ranks *told = &r->of_ranks;
    if ((double)told->ranks * r->threads > r->processors) {
        clod_check_warning(
            r,
            "%d rank%s with %d thread%s on %d processor%s take turns, and every step waits for "
            "the last of them: this machine holds %d. Times are those of machines like this one "
            "with %d each",
            told->ranks, clod_plural(told->ranks), r->threads, clod_plural(r->threads),
            r->processors, clod_plural(r->processors), told->node, told->node);
    }
    if (told->machine > 0.0 && told->all > told->machine) {
        clod_check_warning(
            r,
            "all ranks together may need %.2g GB, this machine has %.2g GB: use more machines",
            1e-9 * told->all, 1e-9 * told->machine);
    }
    if (told->ranks > 0 && told->own < 1.0) {
        clod_check_warning(r, "%d ranks for %zu grains: some have none. Use fewer", told->ranks,
                           r->grains);
    }
}

void clod_check_ranks_write(clod_check_page *to, const clod_check_report *r)
{
    const clod_check_ranks *told = &r->of_ranks;
    char a[32], b[32];
    if (told->ranks == 0) {
        return;
    }
    clod_check_line(to, "ranks", "%d, each with %d thread%s", told->ranks, r->threads,
                    clod_plural(r->threads));
    if (told->groups > 1) {
        clod_check_line(
            to, "", "up to %d groups step parts side by side; of one of them:", told->groups);
    }
    clod_check_line(to, "", "%.0f grains and about %.0f ghosts a rank", told->own,
                    told->ghosts);
    clod_check_line(to, "", "%.3g us a step", MICRO * told->step);
    if (clod_testers_row(r->kind)->write != NULL) {
        clod_check_line(to, "", "wall-clock likely %s, at most %s",
                        clod_check_clock_words(told->clock_likely, a),
                        clod_check_clock_words(told->clock_most, b));
    } else if (told->clock_most > told->clock_likely) {
        clod_check_line(to, "",
                        "wall-clock of the steps %s at this rate, at most %s in a dense fast "
                        "stream",
                        clod_check_clock_words(told->clock_likely, a),
                        clod_check_clock_words(told->clock_most, b));
    } else {
        clod_check_line(to, "", "wall-clock of the steps %s at most",
                        clod_check_clock_words(told->clock_most, a));
    }
    if (told->making > 0.0) {
        clod_check_line(
            to, "", "%s before them while rank 0 makes the bed, and %s for each checkpoint",
            clod_check_clock_words(told->making, a), clod_check_clock_words(told->writing, b));
    }
    clod_check_line(to, "", "memory of rank 0: %s while the bed is made and dealt, %s in steps",
                    clod_check_byte_words(told->begin_0, a),
                    clod_check_byte_words(told->steps_0, b));
    if (told->steps > 0.0) {
        clod_check_line(to, "", "of another rank: %s and %s",
                        clod_check_byte_words(told->begin, a),
                        clod_check_byte_words(told->steps, b));
    }
    clod_check_line(to, "", "of all on one machine: %s; this one has %s",
                    clod_check_byte_words(told->all, a),
                    clod_check_byte_words(told->machine, b));
    clod_check_line(
        to, "",
        "assumed: an even cube; a ghost costs 0.7 of a row; a round of a merge takes 1.5 us "
        "in a machine, 1.6 between machines like this one, with 24 GB/s each; without "
        "imbalance, rebuilds and slow memory (docs/scaling.md has the rest)");
}

static const clod_check_real RANKS_REALS[] = {
    CLOD_CHECK_REAL("ranks_grains_each", of_ranks.own),
    CLOD_CHECK_REAL("ranks_ghosts_each", of_ranks.ghosts),
    CLOD_CHECK_REAL("ranks_step_s", of_ranks.step),
    CLOD_CHECK_REAL("ranks_wall_clock_likely_s", of_ranks.clock_likely),
    CLOD_CHECK_REAL("ranks_wall_clock_most_s", of_ranks.clock_most),
    CLOD_CHECK_REAL("ranks_making_s", of_ranks.making),
    CLOD_CHECK_REAL("ranks_checkpoint_s", of_ranks.writing),
    CLOD_CHECK_REAL("ranks_memory_start_rank_0_bytes", of_ranks.begin_0),
    CLOD_CHECK_REAL("ranks_memory_start_other_bytes", of_ranks.begin),
    CLOD_CHECK_REAL("ranks_memory_steps_rank_0_bytes", of_ranks.steps_0),
    CLOD_CHECK_REAL("ranks_memory_steps_other_bytes", of_ranks.steps),
    CLOD_CHECK_REAL("ranks_memory_all_bytes", of_ranks.all),
    CLOD_CHECK_REAL("machine_memory_bytes", of_ranks.machine),
};

void clod_check_ranks_put(json_t *to, const clod_check_report *r)
{
    if (r->of_ranks.ranks == 0) {
        return;
    }
    json_object_set_new(to, "ranks", json_integer(r->of_ranks.ranks));
    json_object_set_new(to, "ranks_groups", json_integer(r->of_ranks.groups));
    json_object_set_new(to, "ranks_on_this_machine", json_integer(r->of_ranks.node));
    clod_check_put(to, r, RANKS_REALS, sizeof RANKS_REALS / sizeof RANKS_REALS[0]);
}
