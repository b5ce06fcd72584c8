/**
 * @file plan_shear.c
 * Targets of a plan from measured shear points: prorated points, mean densities and preshear shear stresses.
 */

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "analysis/preshear.h"
#include "analysis/spread.h"
#include "analysis/study_file.h"
#include "base/memory.h"
#include "calibrate/plan_loci.h"
#include "calibrate/plan_samples.h"
#include "calibrate/test_kinds.h"

#define SAME 1.000001 ///< of an error over another

typedef clod_plan_maker maker;
typedef clod_plan_sample sample;

/** A table of shear points, and its loci at the preshear stress of the test. */
typedef struct shear_table {
    const clod_locus_group *group;
    const clod_locus_point *points;
} shear_table;

// ---- points

/** Preshears of the points of one seed. */
typedef struct preshears {
    size_t count;
    double tau_p; ///< mean over the points
    double
        error; ///< relative, of tau_p: how preshears differ, beyond the errors that are stated
} preshears;

/** Those of a seed's locus; none without memory, which the report notes. */
static preshears find_preshears(maker *self, const clod_locus *seed,
                                const clod_locus_point *points)
{
    const size_t n = seed->point_count;
    preshears found = {.tau_p = seed->tau_p.value};
    clod_locus_point *own = clod_memory_alloc(n, sizeof *own);
    size_t *first = clod_memory_alloc(n, sizeof *first);
    if (own != NULL && first != NULL) {
        double pairs = 0.0; // of points with one preshear, each with itself too
        for (size_t k = 0; k < n; k++) {
            own[k] = points[seed->marks[k].index];
        }
        clod_preshear_find(own, n, first);
        for (size_t k = 0; k < n; k++) {
            found.count += first[k] == k ? 1 : 0;
            for (size_t m = 0; m < n; m++) {
                pairs += first[k] == first[m] ? 1.0 : 0.0;
            }
        }
        found.error =
            clod_spread_preshears(own, first, n, found.tau_p) * sqrt(pairs) / (double)n;
    } else {
        self->loader->report->lost = true;
    }
    clod_memory_free(own);
    clod_memory_free(first);
    return found;
}

/** A prorated point. One of several preshears has the error of its own one, and shares that of their mean. */
static sample prorated_point(const clod_locus_mark *mark, const clod_locus_point *point,
                             const preshears *of, double given)
{
    sample made = {.stress = mark->sigma,
                   .value = mark->prorated,
                   .error = fmax(point->tau_s_error, given),
                   .specimen = mark->seed};
    if (of->count > 1 && made.error > 0.0) {
        made.error =
            hypot(made.error * of->tau_p, mark->prorated * point->tau_p_error) / point->tau_p;
        made.common = (clod_plan_common){mark->prorated * of->error, (double)of->count - 1.0};
    }
    return made;
}

/** Whether points would lie at the shear stresses of their case if sigma_sh and tau_sh were exchanged; a complaint then. */
static bool are_exchanged(maker *self, size_t test, const clod_locus *locus)
{
    const clod_case *from = self->plan->tests[test].middle;
    const clod_test_kind *kind = clod_test_kinds_of(from);
    bool outside = false, steep = locus->point_count > 0;
    for (size_t k = 0; k < locus->point_count; k++) {
        const clod_locus_mark *mark = &locus->marks[k];
        outside = outside || !kind->has_stress(from, mark->sigma);
        steep = steep && mark->measured > mark->sigma && kind->has_stress(from, mark->measured);
    }
    if (outside && steep) {
        clod_check_fail(
            self->loader, clod_plan_targets_at(self, "locus"),
            "has normal stresses outside the shear_stresses of test %s, and all of its "
            "shear stresses within: are the columns sigma_sh and tau_sh exchanged?",
            self->wish->test);
    }
    return outside && steep;
}

/** The prorated points of a yield locus. */
static void make_points(maker *self, const clod_number *kind, const clod_plan_target *common,
                        const shear_table *table)
{
    const clod_locus_group *group = table->group;
    clod_plan_samples list;
    if (are_exchanged(self, common->test, &group->locus)) {
        return;
    }
    if (clod_plan_samples_init(&list, self, group->locus.point_count)) {
        list.slope = tan(group->locus.phi_lin.value);
        list.error_column = "tau_sh_error";
        for (size_t s = 0; s < group->seed_count; s++) {
            const clod_locus *seed = &group->seeds[s];
            const preshears of = find_preshears(self, seed, table->points);
            for (size_t k = 0; k < seed->point_count; k++) {
                const clod_locus_mark *mark = &seed->marks[k];
                list.items[list.count++] =
                    prorated_point(mark, &table->points[mark->index], &of, common->error);
            }
        }
        clod_plan_samples_merge(&list, 0.0);
        clod_plan_samples_warn_alike(self, &list);
        clod_plan_samples_make(self, kind, common, &list, 0.0);
    }
    clod_plan_samples_fini(&list);
}

// ---- means over specimens

/** A column that a yield locus has the mean of: places in clod_locus_point and clod_locus. */
typedef struct column {
    size_t value, error, mean;
    const char *error_name;
} column;

static const column TAU_P = {offsetof(clod_locus_point, tau_p),
                             offsetof(clod_locus_point, tau_p_error),
                             offsetof(clod_locus, tau_p), "tau_pre_error"};
static const column RHO_B = {offsetof(clod_locus_point, rho_b),
                             offsetof(clod_locus_point, rho_b_error),
                             offsetof(clod_locus, rho_b), "rho_b_error"};

static const column *column_of(const clod_number *kind)
{
    return strcmp(kind->key, "tau_p") == 0 ? &TAU_P : &RHO_B;
}

static double number_at(const clod_locus_point *point, size_t place)
{
    return *(const double *)(const void *)((const char *)point + place);
}

static const clod_locus_value *mean_at(const clod_locus *locus, const column *of)
{
    return (const clod_locus_value *)(const void *)((const char *)locus + of->mean);
}

/** Standard error of the mean of a column over specimens: from their scatter, from the table's errors of each
 *  preshear or from the plan's of each specimen, whichever is largest (as clod_mean_of has it). */
static double mean_error(const shear_table *table, const column *of, double given)
{
    const clod_locus_group *group = table->group;
    const double error = mean_at(&group->locus, of)->error;
    const double told = isfinite(error) ? error : 0.0;
    const double specimens = (double)group->seed_count;
    bool stated = true;
    double squares = 0.0; // of the means of the specimens
    for (size_t s = 0; s < group->seed_count; s++) {
        const clod_locus *seed = &group->seeds[s];
        for (size_t k = 0; k < seed->point_count; k++) {
            const double one = number_at(&table->points[seed->marks[k].index], of->error);
            stated = stated && one > 0.0;
            squares += one * one / (double)seed->point_count / (double)seed->preshear_count;
        }
    }
    return fmax(fmax(told, stated ? sqrt(squares) / specimens : 0.0), given / sqrt(specimens));
}

/** Mean of a specimen over the points that tell it, one at least. */
static double specimen_mean(const clod_locus *locus, const clod_locus_point *points,
                            const column *of, int64_t seed)
{
    double sum = 0.0, count = 0.0;
    for (size_t k = 0; k < locus->point_count; k++) {
        const double value = number_at(&points[locus->marks[k].index], of->value);
        const bool counts = locus->marks[k].seed == seed && value > 0.0;
        sum += counts ? value : 0.0;
        count += counts ? 1.0 : 0.0;
    }
    return sum / count;
}

/** By how much specimens are above their mean: so a dense one can be seen to be a strong one. */
static void take_specimens(const clod_locus *locus, const clod_locus_point *points,
                           const column *of, clod_plan_repeats *to)
{
    to->count = 0;
    for (size_t k = 0; k < locus->point_count; k++) {
        const int64_t seed = locus->marks[k].seed;
        bool first = true;
        for (size_t m = 0; m < k; m++) {
            first = first && locus->marks[m].seed != seed;
        }
        if (first && to->count < CLOD_PLAN_SPECIMENS) {
            to->differences[to->count] = (clod_plan_difference){
                seed, specimen_mean(locus, points, of, seed) - mean_at(locus, of)->value};
        }
        to->count += first ? 1 : 0;
    }
}

/** What the mean tau_p of the seeds has in common with the points that they prorated: all that preshears differ by. */
static void share_preshear(maker *self, const shear_table *table, sample *to)
{
    const clod_locus_group *group = table->group;
    double squares = 0.0;
    for (size_t s = 0; s < group->seed_count; s++) {
        const preshears of = find_preshears(self, &group->seeds[s], table->points);
        squares += pow(of.tau_p * of.error, 2.0);
        to->common.degrees += (double)of.count - 1.0;
    }
    to->common.error = sqrt(squares) / (double)group->seed_count;
    if (to->common.error > 0.0) {
        to->error = sqrt(
            fmax(to->error * to->error - squares / pow((double)group->seed_count, 2.0), 0.0));
    }
}

/** Density or preshear shear stress of a yield locus: the mean of its specimens. */
static void make_mean(maker *self, const clod_number *kind, const clod_plan_target *common,
                      const shear_table *table)
{
    const clod_locus *locus = &table->group->locus;
    const column *of = column_of(kind);
    if (isnan(mean_at(locus, of)->value)) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                        "has no rho_b at the preshear stress of test %s; add the column, or "
                        "give number and value",
                        self->wish->test);
        return;
    }
    sample one = {.value = mean_at(locus, of)->value,
                  .error = mean_error(table, of, common->error)};
    const double scatter = mean_at(locus, of)->scatter / sqrt((double)locus->seed_count);
    take_specimens(locus, table->points, of, &one.repeats);
    one.repeats.estimate = isfinite(scatter) && one.error <= SAME * scatter;
    if (of == &TAU_P) {
        share_preshear(self, table, &one);
    }
    const clod_plan_samples list = {.items = &one, .count = 1, .error_column = of->error_name};
    clod_plan_samples_make(self, kind, common, &list, 0.0);
}

// ---- the table

/** "0.6, 1.2": preshear stresses of a table. */
static const char *list_preshears(const clod_locus_study *study, char *buffer, size_t size)
{
    size_t used = 0;
    buffer[0] = '\0';
    for (size_t g = 0; g < study->count && used < size; g++) {
        used += (size_t)snprintf(buffer + used, size - used, "%s%.6g", g == 0 ? "" : ", ",
                                 1e-3 * study->groups[g].locus.sigma_p.value);
    }
    return buffer;
}

/** Largest error of the points of a locus, as the table states it of a number. */
static double largest(const clod_locus *locus, const clod_locus_point *points,
                      const clod_number *kind)
{
    const size_t error =
        kind->at_stress ? offsetof(clod_locus_point, tau_s_error) : column_of(kind)->error;
    double most = 0.0;
    for (size_t k = 0; k < locus->point_count; k++) {
        most = fmax(most, number_at(&points[locus->marks[k].index], error));
    }
    return most;
}

/** Points, or a mean, of the locus with the preshear stress of the test. */
static void make_marks(maker *self, size_t test, const clod_number *kind,
                       const clod_locus_study *study, const clod_locus_point *points,
                       size_t count)
{
    const double preshear = clod_case_shear(self->plan->tests[test].middle)->preshear_stress;
    clod_plan_target common;
    if (!clod_plan_samples_common(self, test, kind, &common)) {
        return;
    }
    for (size_t g = 0; g < study->count; g++) {
        const clod_locus *locus = &study->groups[g].locus;
        if (!clod_plan_samples_same(locus->sigma_p.value, preshear)) {
            continue;
        }
        const shear_table table = {&study->groups[g], points};
        if (kind->at_stress) {
            make_points(self, kind, &common, &table);
            clod_plan_loci_keep(self, test, study, g, points, count, common.error);
        } else {
            make_mean(self, kind, &common, &table);
        }
        for (size_t k = 0; k < locus->warning_count; k++) {
            clod_plan_samples_warn(self, locus->warnings[k]);
        }
        const char *specimen = clod_locus_specimen_note(locus);
        if (specimen != NULL) {
            clod_plan_samples_warn_one(self, &common, largest(locus, points, kind), specimen);
        }
        return;
    }
    char list[160];
    clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                    "has no points with the preshear stress of test %s, %.6g kPa; it has %s "
                    "kPa: give the case one of these",
                    self->wish->test, 1e-3 * preshear,
                    list_preshears(study, list, sizeof list));
}

/** The points of a measured yield locus; false with status. */
static bool make_locus(maker *self, size_t test, const clod_number *kind, clod_status *status)
{
    clod_locus_point *points;
    size_t count;
    if (!clod_locus_read(self->wish->locus, NULL, &points, &count, status)) {
        return false;
    }
    clod_locus_study *study = clod_study_of_points(self->wish->locus, points, count, status);
    const bool good = study != NULL;
    if (good) {
        make_marks(self, test, kind, study, points, count);
    }
    clod_locus_study_destroy(&study);
    clod_locus_free(points);
    return good;
}

const clod_plan_table CLOD_PLAN_TABLE_SHEAR = {
    .is = CLOD_PLAN_IS_SHEAR, .numbers = {"tau", "rho_b", "tau_p"}, .make = make_locus};
