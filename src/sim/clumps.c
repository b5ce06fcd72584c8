#include "sim/clumps.h"

#include <math.h>
#include <string.h>

#include "setup/domain.h"
#include "sim/clumps_report.h"

static size_t clumps_size(const clod_case *from)
{
    return from->clumps.present ? sizeof(clod_clump_memory) : 0;
}

static void clumps_begin(void *memory, const clod_case *from, const clod_state *state,
                         const clod_free_start *bed)
{
    (void)bed;
    clod_clump_memory *self = memory;
    if (from->clumps.present) {
        self->sampled = state->time;
    }
}

static bool clumps_act(void *memory, const clod_free_moment *now, clod_status *status)
{
    (void)memory;
    return !now->from->clumps.present || clod_grains_keep_clumps(&now->state->grains, status);
}

/** Add numbers that were so for a time; all members are doubles. */
static void add_times(void *sum, const void *of, size_t size, double time)
{
    double *to = sum;
    const double *from = of;
    for (size_t k = 0; k < size / sizeof(double); k++) {
        to[k] += time * from[k];
    }
}

static void keep_most(clod_clump_stats *most, const clod_clump_stats *now)
{
    double *to = (double *)most;
    const double *from = (const double *)now;
    for (size_t k = 0; k < sizeof *now / sizeof(double); k++) {
        to[k] = fmax(to[k], from[k]);
    }
}

/** Numbers of one count, from its clumps. */
static void note_count(clod_clump_count *self, const clod_clumps_found *found, double time)
{
    self->now = found->stats;
    add_times(&self->mean, &self->now, sizeof self->now, time);
    add_times(&self->sizes, &found->sizes, sizeof found->sizes, time);
    keep_most(&self->most, &self->now);
}

_Static_assert(CLOD_CLUMPS_CHOICES == 1 + CLOD_CASE_CLUMP_COUNTS, "all, and each count");

/** A look at all clumps. */
static clod_clumps_look look_at_all(const clod_case_clumps *asked)
{
    return (clod_clumps_look){
        .bond = asked->bond, .choices = 1, .choice = {{.least = asked->least}}};
}

/** And at those of the case's counts. */
static void add_counts(clod_clumps_look *self, const clod_case_clumps *asked)
{
    for (size_t k = 0; k < asked->count_count; k++) {
        const clod_case_clump_count *count = &asked->counts[k];
        self->choice[self->choices++] =
            (clod_clump_choice){.least = asked->least,
                                .cuts = count->has_region,
                                .free = count->free,
                                .region = clod_setup_domain_region(&count->region)};
    }
}

static bool clumps_sample(void *memory, const clod_free_moment *now, clod_status *status)
{
    clod_clump_memory *self = memory;
    if (!now->from->clumps.present) {
        return true;
    }
    clod_clumps_seen seen;
    clod_clumps_look look = look_at_all(&now->from->clumps);
    look.follows = true;
    add_counts(&look, &now->from->clumps);
    const double time = clod_steady_time_within(&now->steady, self->sampled, now->state->time);
    self->sampled = now->state->time;
    self->time += time;
    if (!clod_grains_keep_clumps(&now->state->grains, status) ||
        !clod_clumps_look_at(&look, now->survey, &seen, status)) {
        return false;
    }
    for (int32_t k = 0; k < look.choices; k++) {
        note_count(&self->count[k], &seen.found[k], time);
    }
    if (time > 0.0) {
        clod_clump_lives_merge(&self->lives, &seen.lives);
    }
    return true;
}

static bool clumps_picture(void *memory, const clod_free_moment *now, const clod_frame *frame,
                           clod_status *status)
{
    (void)memory;
    (void)frame;
    if (!now->from->clumps.present) {
        return true;
    }
    clod_clumps_seen seen;
    const clod_clumps_look look = look_at_all(&now->from->clumps);
    return clod_grains_keep_clumps(&now->state->grains, status) &&
           clod_clumps_look_at(&look, now->survey, &seen, status);
}

static bool clumps_told(const clod_case *from)
{
    return from->clumps.present;
}

const clod_free_measure CLOD_MEASURE_CLUMPS = {.key = "clumps",
                                               .size = clumps_size,
                                               .begin = clumps_begin,
                                               .act = clumps_act,
                                               .look = clumps_sample,
                                               .picture = clumps_picture,
                                               .columns = clod_clumps_report_columns,
                                               .column = clod_clumps_report_column,
                                               .row = clod_clumps_report_row,
                                               .report = clod_clumps_report_lines,
                                               .told = clumps_told,
                                               .json = clod_clumps_report_json,
                                               .paths = clod_clumps_report_paths,
                                               .write = clod_clumps_report_files};
