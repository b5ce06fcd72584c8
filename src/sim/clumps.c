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

/** Clumps cross ranks: they are found where all contacts are. */
static void clumps_sight(const void *memory, const clod_free_moment *now, clod_sight *sees)
{
    (void)memory;
    sees->whole |= now->from->clumps.present && now->row;
}

static bool clumps_act(void *memory, const clod_free_moment *now, clod_status *status)
{
    (void)memory;
    return !now->from->clumps.present || clod_grains_keep_clumps(&now->state->grains, status);
}

/** Number and size of each grain's clump. */
static void show(const clod_clumps *clumps, clod_grains *grains)
{
    for (size_t g = 0; g < grains->count; g++) {
        const int32_t k = clumps->of[g];
        grains->clump[g].number = k >= 0 ? clumps->clump[k].id : 0;
        grains->clump[g].size = k >= 0 ? clumps->clump[k].grains : 0;
    }
}

/** Grains that have come into a clump, or are in none any more, since the last sample; those count
 *  in the steady time. */
static void note_grains(clod_clump_memory *self, clod_state *state, bool steady)
{
    for (size_t g = 0; g < state->grains.count; g++) {
        clod_grain_clump *clump = &state->grains.clump[g];
        clump->seen = clump->size;
        if (clump->size > 0 && clump->since < 0.0) {
            clump->since = state->time;
        } else if (clump->size == 0 && clump->since >= 0.0) {
            const double time = state->time - clump->since;
            clump->since = -1.0;
            if (steady) {
                self->lived_least = self->left == 0 ? time : fmin(time, self->lived_least);
                self->lived_most = fmax(time, self->lived_most);
                self->left++;
                self->lived_count[clod_time_class(time)]++;
                clod_exact_add(&self->lived, time);
            }
        }
    }
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
static bool note_count(clod_clump_count *self, const clod_clumps *clumps, double time,
                       clod_status *status)
{
    clod_clump_sizes sizes;
    if (!clod_clumps_sum_up(clumps, &self->now, &sizes, status)) {
        return false;
    }
    add_times(&self->mean, &self->now, sizeof self->now, time);
    add_times(&self->sizes, &sizes, sizeof sizes, time);
    keep_most(&self->most, &self->now);
    return true;
}

/** All clumps, whose grains know them then. */
static bool sample_all(clod_clump_memory *self, const clod_free_moment *now,
                       const clod_bonds *bonds, double time, clod_status *status)
{
    clod_clumps clumps = {0};
    const clod_clump_choice choice = {.least = now->from->clumps.least};
    const bool good = clod_clumps_find(&clumps, now->state, bonds, &choice, status) &&
                      note_count(&self->count[0], &clumps, time, status);
    if (good) {
        show(&clumps, &now->state->grains);
        note_grains(self, now->state, time > 0.0);
    }
    clod_clumps_fini(&clumps);
    return good;
}

/** Those of the case's counts. */
static bool sample_counts(clod_clump_memory *self, const clod_free_moment *now,
                          const clod_bonds *bonds, double time, clod_status *status)
{
    const clod_case_clumps *asked = &now->from->clumps;
    bool good = true;
    for (size_t k = 0; good && k < asked->count_count; k++) {
        clod_clumps clumps = {0};
        const clod_case_clump_count *count = &asked->counts[k];
        const clod_outlet region = clod_setup_domain_region(&count->region);
        const clod_clump_choice choice = {
            .least = asked->least,
            .region = count->has_region ? &region : NULL,
            .free = count->free,
        };
        good = clod_clumps_find(&clumps, now->state, bonds, &choice, status) &&
               note_count(&self->count[1 + k], &clumps, time, status);
        clod_clumps_fini(&clumps);
    }
    return good;
}

static bool clumps_sample(void *memory, const clod_free_moment *now, clod_status *status)
{
    clod_clump_memory *self = memory;
    if (!now->from->clumps.present) {
        return true;
    }
    clod_bonds bonds = {0};
    const double time = clod_steady_time_within(&now->steady, self->sampled, now->state->time);
    self->sampled = now->state->time;
    self->time += time;
    const bool good = clod_grains_keep_clumps(&now->state->grains, status) &&
                      clod_bonds_find(&bonds, now->state, now->survey->contacts,
                                      now->from->clumps.bond, status) &&
                      sample_all(self, now, &bonds, time, status) &&
                      sample_counts(self, now, &bonds, time, status);
    clod_bonds_fini(&bonds);
    return good;
}

static bool clumps_picture(void *memory, const clod_free_moment *now, const clod_frame *frame,
                           clod_status *status)
{
    (void)memory;
    (void)frame;
    if (!now->from->clumps.present) {
        return true;
    }
    clod_bonds bonds = {0};
    clod_clumps clumps = {0};
    const clod_clump_choice choice = {.least = now->from->clumps.least};
    const bool good = clod_grains_keep_clumps(&now->state->grains, status) &&
                      clod_bonds_find(&bonds, now->state, now->survey->contacts,
                                      now->from->clumps.bond, status) &&
                      clod_clumps_find(&clumps, now->state, &bonds, &choice, status);
    if (good) {
        show(&clumps, &now->state->grains);
    }
    clod_clumps_fini(&clumps);
    clod_bonds_fini(&bonds);
    return good;
}

static bool clumps_picture_needs_all(const clod_case *from)
{
    return from->clumps.present;
}

const clod_free_measure CLOD_MEASURE_CLUMPS = {.key = "clumps",
                                               .size = clumps_size,
                                               .begin = clumps_begin,
                                               .sight = clumps_sight,
                                               .act = clumps_act,
                                               .look = clumps_sample,
                                               .picture = clumps_picture,
                                               .picture_needs_all = clumps_picture_needs_all,
                                               .columns = clod_clumps_report_columns,
                                               .column = clod_clumps_report_column,
                                               .row = clod_clumps_report_row,
                                               .report = clod_clumps_report_lines,
                                               .json = clod_clumps_report_json,
                                               .write = clod_clumps_report_files};
