/**
 * @file study.c
 * Points sorted into consolidation stresses and seeds, each evaluated, seeds combined.
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "analysis/bulk_density.h"
#include "analysis/warnings.h"
#include "base/given.h"
#include "base/memory.h"
#include "clod/locus.h"

#define KILO 1000.0
#define NEAR                                                                                   \
    0.1 ///< relative: a preshear stress so close may have been meant for the same locus

/** A point with the place where it belongs. */
typedef struct sorted {
    clod_locus_point point;
    size_t group;
    size_t index; ///< in the points as given: their order is kept
} sorted;

static int by_stress(const void *left, const void *right)
{
    const double a = ((const sorted *)left)->point.sigma_p;
    const double b = ((const sorted *)right)->point.sigma_p;
    return (a > b) - (a < b);
}

static int by_place(const void *left, const void *right)
{
    const sorted *a = left;
    const sorted *b = right;
    if (a->group != b->group) {
        return a->group > b->group ? 1 : -1;
    }
    if (a->point.seed != b->point.seed) {
        return a->point.seed > b->point.seed ? 1 : -1;
    }
    return (a->index > b->index) - (a->index < b->index);
}

/** Sort points by group, seed and their own order; returns the number of groups. */
static size_t sort_points(const clod_locus_point *points, size_t count, sorted *items)
{
    for (size_t i = 0; i < count; i++) {
        items[i] = (sorted){points[i], 0, i};
    }
    qsort(items, count, sizeof *items, by_stress);
    size_t first = 0;
    for (size_t i = 1; i < count; i++) {
        const bool apart = items[i].point.sigma_p >
                           (1.0 + CLOD_WARNINGS_SAME_PRESHEAR) * items[first].point.sigma_p;
        items[i].group = items[i - 1].group + (apart ? 1 : 0);
        first = apart ? i : first;
    }
    const size_t groups = items[count - 1].group + 1;
    qsort(items, count, sizeof *items, by_place);
    return groups;
}

/** End of the run of items that share group and, if asked, seed with the first. */
static size_t run_end(const sorted *items, size_t first, size_t count, bool same_seed)
{
    size_t at = first;
    while (at < count && items[at].group == items[first].group &&
           (!same_seed || items[at].point.seed == items[first].point.seed)) {
        at++;
    }
    return at;
}

static bool evaluate_seed(const sorted *items, size_t count, clod_locus_point *points,
                          clod_locus *locus, clod_status *status)
{
    for (size_t i = 0; i < count; i++) {
        points[i] = items[i].point;
    }
    if (clod_locus_evaluate(points, count, locus, status)) {
        for (size_t i = 0; i < count; i++) {
            locus->marks[i].index = items[i].index;
        }
        return true;
    }
    char text[512], seed[32] = "";
    snprintf(text, sizeof text, "%.*s", (int)sizeof text - 1, status->text);
    if (points[0].seed != 0) { // as of a table without that column
        snprintf(seed, sizeof seed, ", seed %lld", (long long)points[0].seed);
    }
    return clod_status_fail(status, status->code, "Preshear at %.3f kPa%s: %s",
                            points[0].sigma_p / KILO, seed, text);
}

static bool evaluate_group(const sorted *items, size_t count, clod_locus_point *points,
                           clod_locus_group *group, clod_status *status)
{
    size_t seeds = 0;
    for (size_t at = 0; at < count; at = run_end(items, at, count, true)) {
        seeds++;
    }
    group->seeds = clod_memory_alloc(seeds, sizeof *group->seeds);
    if (group->seeds == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %zu seeds.", seeds);
    }
    size_t at = 0;
    while (at < count) {
        const size_t end = run_end(items, at, count, true);
        if (!evaluate_seed(items + at, end - at, points, &group->seeds[group->seed_count],
                           status)) {
            return false;
        }
        group->seed_count++;
        at = end;
    }
    return clod_locus_combine(group->seeds, seeds, &group->locus, status);
}

/** What to do about preshear stresses that another locus has within a tenth of those of items [first, end); "": there are none. */
static void tell_near(const sorted *items, size_t count, size_t first, size_t end,
                      char text[CLOD_LOCUS_WARNING_TEXT])
{
    const double own = items[first].point.sigma_p;
    double below = 0.0;
    double above = INFINITY;
    for (size_t i = 0; i < count; i++) { // groups are in ascending order
        const double other = items[i].point.sigma_p;
        below = i < first ? fmax(below, other) : below;
        above = i >= end ? fmin(above, other) : above;
    }
    const bool low = own <= (1.0 + NEAR) * below, high = above <= (1.0 + NEAR) * own;
    char others[64] = "";
    if (low) {
        snprintf(others, sizeof others, "%.3f%s", below / KILO, high ? " and " : "");
    }
    if (high) {
        const size_t used = strlen(others);
        snprintf(others + used, sizeof others - used, "%.3f", above / KILO);
    }
    text[0] = '\0';
    if (low || high) {
        snprintf(text, CLOD_LOCUS_WARNING_TEXT,
                 "Other rows have a preshear of %s kPa, and more than %.0f %% apart is another "
                 "locus. If all are of one, give them one nominal sigma_pre: each tau_sh is "
                 "prorated with the tau_pre of its row.",
                 others, 100.0 * CLOD_WARNINGS_SAME_PRESHEAR);
    }
}

static bool evaluate_all(clod_locus_study *self, const sorted *items, size_t count,
                         clod_locus_point *points, clod_status *status)
{
    size_t at = 0;
    for (size_t g = 0; at < count; g++) {
        const size_t end = run_end(items, at, count, false);
        char near[CLOD_LOCUS_WARNING_TEXT];
        tell_near(items, count, at, end, near);
        clod_status why = {0};
        if (!evaluate_group(items + at, end - at, points, &self->groups[g], &why)) {
            return clod_status_fail(status, why.code, "%s%s%s", why.text,
                                    near[0] != '\0' ? " " : "", near);
        }
        if (near[0] != '\0') {
            clod_warnings_add(&self->groups[g].locus, "%s", near);
        }
        at = end;
    }
    return true;
}

/** Warn of the least density, once: a wrong unit is that of all rows. */
static void check_density(clod_locus_study *self)
{
    clod_locus *least = NULL;
    for (size_t g = 0; g < self->count; g++) {
        clod_locus *one = &self->groups[g].locus; // some may have no density, NAN
        least =
            one->rho_b.value < (least != NULL ? least->rho_b.value : HUGE_VAL) ? one : least;
    }
    char text[CLOD_LOCUS_WARNING_TEXT];
    if (least != NULL && clod_bulk_density_warn(least->rho_b.value, text)) {
        clod_warnings_add(least, "%s", text);
    }
}

/** Remark on the flow function: groups are in ascending order of consolidation. */
static bool check_strengths(clod_locus_study *self, clod_status *status)
{
    clod_warnings_strength *points = clod_memory_alloc(self->count, sizeof *points);
    if (points == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %zu consolidations.",
                                self->count);
    }
    for (size_t g = 0; g < self->count; g++) {
        const clod_locus *locus = &self->groups[g].locus;
        points[g] = (clod_warnings_strength){locus->sigma_p.value, locus->sigma_c.value,
                                             locus->sigma_c.error};
    }
    clod_warnings_strength_falls(points, self->count, self->warning);
    clod_memory_free(points);
    return true;
}

clod_locus_study *clod_locus_study_create(const clod_locus_point *points, size_t count,
                                          clod_status *status)
{
    CLOD_NEED(status);
    if (count == 0) {
        clod_status_fail(status, CLOD_USAGE, "There are no shear points.");
        return NULL;
    }
    if (!CLOD_GIVEN(points, status)) {
        return NULL;
    }
    clod_locus_study *self = clod_memory_alloc(1, sizeof *self);
    sorted *items = clod_memory_alloc(count, sizeof *items);
    clod_locus_point *scratch = clod_memory_alloc(count, sizeof *scratch);
    bool done = self != NULL && items != NULL && scratch != NULL;
    if (done) {
        self->count = sort_points(points, count, items);
        self->groups = clod_memory_alloc(self->count, sizeof *self->groups);
        done = self->groups != NULL;
    }
    if (!done) {
        clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", count);
    }
    done = done && evaluate_all(self, items, count, scratch, status) &&
           check_strengths(self, status);
    clod_memory_free(items);
    clod_memory_free(scratch);
    if (done) {
        check_density(self);
    } else {
        clod_locus_study_destroy(&self);
    }
    return self;
}

void clod_locus_study_destroy(clod_locus_study **self)
{
    if (self == NULL || *self == NULL) {
        return;
    }
    for (size_t g = 0; (*self)->groups != NULL && g < (*self)->count; g++) {
        clod_locus_group *group = &(*self)->groups[g];
        for (size_t s = 0; s < group->seed_count; s++) {
            clod_locus_fini(&group->seeds[s]);
        }
        clod_memory_free(group->seeds);
        clod_locus_fini(&group->locus);
    }
    clod_memory_free((*self)->groups);
    clod_memory_free(*self);
    *self = NULL;
}
