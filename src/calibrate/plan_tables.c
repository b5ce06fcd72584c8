/**
 * @file plan_tables.c
 * Targets of a plan from measured tables: yield loci of shear tests, wall yield loci.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/mean.h"
#include "analysis/study_file.h"
#include "base/memory.h"
#include "calibrate/plan_targets.h"
#include "calibrate/test_kinds.h"
#include "clod/locus.h"
#include "clod/wall_locus.h"

typedef clod_plan_maker maker;

/** A measured point. */
typedef struct sample {
    double stress, value, error; ///< SI; error 0: the table has none
} sample;

/** Those of a table. */
typedef struct sample_list {
    sample *items; ///< [count] owned
    size_t count;
    double slope;    ///< of value over stress, 0: an angle has hardly any
    double *scratch; ///< [count] owned
} sample_list;

/** Room for so many; false when there is none, which the report notes. */
static bool list_init(sample_list *self, maker *make, size_t room)
{
    *self = (sample_list){.items = clod_memory_alloc(room, sizeof *self->items),
                          .scratch = clod_memory_alloc(room, sizeof *self->scratch)};
    const bool good = self->items != NULL && self->scratch != NULL;
    make->loader->report->lost = make->loader->report->lost || !good;
    return good;
}

static void list_fini(sample_list *self)
{
    clod_memory_free(self->items);
    clod_memory_free(self->scratch);
}

/** What all points of a table have in common; false after a complaint. */
static bool common_of(maker *self, size_t test, const clod_number *kind, clod_plan_target *to)
{
    *to = (clod_plan_target){
        .test = test, .held_back = self->wish->held_back, .measure = kind->measure};
    return clod_plan_targets_deviation(self, "error", self->wish->error, kind, false,
                                       &to->error) &&
           clod_plan_targets_deviation(self, "discrepancy", self->wish->discrepancy, kind,
                                       false, &to->discrepancy);
}

static const clod_plan_table *table_of(const maker *self, size_t test)
{
    return clod_test_kinds_of(self->plan->tests[test].middle)->table;
}

/** A measured point, or the mean of those at one stress, as a target. */
static void make_point(maker *self, const clod_number *kind, const clod_plan_target *common,
                       sample point)
{
    clod_plan_target made = *common;
    made.normal_stress = point.stress;
    made.value = point.value;
    made.error = point.error;
    if (made.error <= 0.0) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, ""),
                        "needs the key error: the table has no %s at %.6g kPa",
                        table_of(self, made.test)->error_column, 1e-3 * point.stress);
    } else if (made.value < kind->least || made.value > kind->most) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                        "has a %s of %.6g %s at %.6g kPa; allowed is %.6g to %.6g %s",
                        kind->key, kind->measure.factor * made.value, kind->measure.unit,
                        1e-3 * point.stress, kind->measure.factor * kind->least,
                        kind->measure.factor * kind->most, kind->measure.unit);
    } else if (clod_plan_targets_check_stress(self, made.test, kind, kind->key, point.stress)) {
        clod_plan_targets_add(self, &made, kind->key);
    }
}

// ---- repeats

/** Move the points at the stress of the first to its side, all in their order; how many there are. */
static size_t gather(sample *points, size_t count)
{
    size_t same = 1;
    for (size_t k = 1; k < count; k++) {
        const sample one = points[k];
        if (fabs(one.stress / points[0].stress - 1.0) < CLOD_NUMBER_SAME_STRESS) {
            memmove(&points[same + 1], &points[same], (k - same) * sizeof *points);
            points[same++] = one;
        }
    }
    return same;
}

/**
 * Repeats at one stress are one measurement of the material: the mean of the values, moved along the
 * slope to the mean of the stresses, with the larger of the stated error of that mean,
 * sqrt(sum e_i^2)/n, and the standard error from their scatter, s/sqrt(n) (clod_mean_of has the
 * source). Error 0: a point has none.
 */
static sample mean_of(const sample *points, size_t count, double slope, double *values)
{
    sample mean = {0};
    double stated = 0.0;
    bool known = true;
    for (size_t k = 0; k < count; k++) {
        mean.stress += points[k].stress / (double)count;
        stated += points[k].error * points[k].error;
        known = known && points[k].error > 0.0;
    }
    for (size_t k = 0; k < count; k++) {
        values[k] = points[k].value + slope * (mean.stress - points[k].stress);
    }
    const clod_locus_value of = clod_mean_of(values, count, stated);
    mean.value = of.value;
    mean.error = known ? of.error : 0.0;
    return mean;
}

/** A target of each stress of a table. */
static void make_points(maker *self, const clod_number *kind, const clod_plan_target *common,
                        const sample_list *from)
{
    for (size_t k = 0; k < from->count; k++) {
        sample *one = &from->items[k];
        one->error = one->error > 0.0 ? one->error : common->error;
    }
    for (size_t first = 0, same; first < from->count; first += same) {
        sample *points = &from->items[first];
        same = gather(points, from->count - first);
        make_point(self, kind, common, mean_of(points, same, from->slope, from->scratch));
    }
}

// ---- shear tests

/** Stated error of a mark's point. */
static double error_of(const clod_locus_mark *mark, const clod_locus_point *points,
                       size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (points[i].seed == mark->seed && points[i].sigma_s == mark->sigma &&
            points[i].tau_s == mark->measured) {
            return points[i].tau_s_error;
        }
    }
    return 0.0;
}

/** What `clod locus` says of a table beside its numbers. */
static void warn(maker *self, const char *warning)
{
    clod_warning_list_add(&self->plan->warnings, "%s: %s", self->wish->locus, warning);
}

/** The prorated points of a yield locus. */
static void make_locus_points(maker *self, const clod_number *kind,
                              const clod_plan_target *common, const clod_locus *locus,
                              const clod_locus_point *points, size_t count)
{
    sample_list list;
    if (list_init(&list, self, locus->point_count)) {
        list.slope = tan(locus->phi_lin.value);
        for (size_t k = 0; k < locus->point_count; k++) {
            const clod_locus_mark *mark = &locus->marks[k];
            list.items[list.count++] =
                (sample){mark->sigma, mark->prorated, error_of(mark, points, count)};
        }
        make_points(self, kind, common, &list);
    }
    list_fini(&list);
}

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

/** Points of the locus with the preshear stress of the test. */
static void make_marks(maker *self, size_t test, const clod_number *kind,
                       const clod_locus_study *study, const clod_locus_point *points,
                       size_t count)
{
    const double preshear = clod_case_shear(self->plan->tests[test].middle)->preshear_stress;
    clod_plan_target common;
    if (!common_of(self, test, kind, &common)) {
        return;
    }
    for (size_t g = 0; g < study->count; g++) {
        const clod_locus *locus = &study->groups[g].locus;
        if (fabs(locus->sigma_p.value / preshear - 1.0) >= CLOD_NUMBER_SAME_STRESS) {
            continue;
        }
        make_locus_points(self, kind, &common, locus, points, count);
        for (size_t k = 0; k < locus->warning_count; k++) {
            warn(self, locus->warnings[k]);
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
    .number = "tau", .error_column = "tau_sh_error", .make = make_locus};

// ---- wall friction tests

/** phi_x of a point at a normal stress. */
static sample angle_of(const clod_wall_locus_mark *mark, double stress)
{
    const clod_locus_value *phi_x = &mark->phi_x;
    return (sample){stress, phi_x->value, isfinite(phi_x->error) ? phi_x->error : 0.0};
}

/** phi_x of the points of a wall yield locus, or of those at the wish's normal stress. */
static void take_angles(maker *self, const clod_wall_locus *locus, sample_list *to)
{
    const double wanted = self->wish->normal_stress;
    size_t found = 0;
    for (size_t k = 0; k < locus->point_count; k++) {
        const clod_wall_locus_point *of = &locus->marks[k].point;
        const double stress = of->wall_stress > 0.0 ? of->wall_stress : of->sigma;
        if (wanted > 0.0 && fabs(stress / wanted - 1.0) >= CLOD_NUMBER_SAME_STRESS) {
            continue;
        }
        found++;
        if (of->unsteady) {
            clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                            "was not steady at %.6g kPa, and phi_x there is none of steady "
                            "shear; leave that point out",
                            1e-3 * stress);
            continue;
        }
        to->items[to->count++] = angle_of(&locus->marks[k], stress);
    }
    if (found == 0) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "normal_stress"),
                        "%.6g kPa: the table has no point there", 1e-3 * wanted);
    }
}

static void make_angles(maker *self, size_t test, const clod_number *kind,
                        const clod_wall_locus *locus)
{
    sample_list list;
    clod_plan_target common;
    if (!common_of(self, test, kind, &common)) {
        return;
    }
    if (list_init(&list, self, locus->point_count)) {
        take_angles(self, locus, &list);
        make_points(self, kind, &common, &list);
    }
    list_fini(&list);
}

/** The points of a measured wall yield locus; false with status. */
static bool make_wall(maker *self, size_t test, const clod_number *kind, clod_status *status)
{
    clod_wall_locus_point *points;
    size_t count;
    if (!clod_wall_locus_read(self->wish->locus, &points, &count, status)) {
        return false;
    }
    clod_wall_locus locus;
    const bool good = clod_wall_locus_evaluate(points, count, &locus, status);
    clod_locus_free(points);
    if (good) {
        make_angles(self, test, kind, &locus);
        for (size_t k = 0; k < locus.warning_count; k++) {
            warn(self, locus.warnings[k]);
        }
        clod_wall_locus_fini(&locus);
    }
    return good;
}

const clod_plan_table CLOD_PLAN_TABLE_WALL = {
    .number = "phi_x", .error_column = "tau_w_error", .one_stress = true, .make = make_wall};

void clod_plan_tables_make(clod_plan_maker *self, size_t test)
{
    const clod_plan_wish *wish = self->wish;
    const clod_plan_table *table = table_of(self, test);
    if (table == NULL) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                        "test %s is neither a shear test nor a wall friction test; give "
                        "number and value",
                        wish->test);
        return;
    }
    if (wish->number != NULL || wish->value != NULL ||
        (!table->one_stress && wish->normal_stress > 0.0)) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                        "has number%s beside it; the table has them all",
                        table->one_stress ? " or value" : ", value or normal_stress");
        return;
    }
    clod_status status = {CLOD_OK, ""};
    if (!table->make(self, test, clod_number_find(&self->plan->tests[test], table->number),
                     &status)) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"), "%.800s",
                        status.text);
    }
}
