/**
 * @file plan_curves.c
 * Targets of a plan from measured curves over sigma_1: bulk densities, flow functions.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/bulk_density.h"
#include "base/memory.h"
#include "base/text.h"
#include "calibrate/plan_samples.h"
#include "hopper/tables.h"

typedef clod_plan_maker maker;

#define STEP 1.2    ///< of a stress over another: closer points are of one consolidation
#define AROUND 1.01 ///< of a stress: over which a slope is taken
/** sigma_1 over the preshear stress: the Mohr circle through a point of an effective yield locus of phi_e
 *  reaches to 1/(1 - sin(phi_e)) where it touches, 6 times at 56 deg. */
#define MOST_OVER_PRESHEAR 6.0

/** The mean of the points of each consolidation, in ascending order: between two specimens of one, at
 *  almost the same sigma_1, a slope would be nothing but their scatter. @return how many */
static size_t join(const clod_curve *sorted, clod_curve_point *to)
{
    size_t count = 0;
    for (size_t first = 0, end; first < sorted->count; first = end) {
        clod_curve_point mean = {0};
        for (end = first;
             end < sorted->count && sorted->points[end].x <= STEP * sorted->points[first].x;
             end++) {
            mean.x += sorted->points[end].x;
            mean.y += sorted->points[end].y;
        }
        mean.x /= (double)(end - first);
        mean.y /= (double)(end - first);
        to[count++] = mean;
    }
    return count;
}

/** The curve through sorted points, kept by the plan; NULL: no memory, which the report notes. */
static const clod_curve *keep_curve(maker *self, const clod_curve *through)
{
    clod_plan_curve *made = clod_memory_alloc(1, sizeof *made);
    clod_curve_point *points = clod_memory_alloc(through->count, sizeof *points);
    if (made == NULL || points == NULL) {
        clod_memory_free(made);
        clod_memory_free(points);
        self->loader->report->lost = true;
        return NULL;
    }
    *made =
        (clod_plan_curve){{.way = CLOD_CURVE_EXTENDED, .points = points}, self->plan->curves};
    made->curve.count = join(through, points);
    self->plan->curves = made;
    return &made->curve;
}

/** Slope of a curve at a stress; 0: it is a point. */
static double slope_at(const clod_curve *curve, double stress)
{
    const double above = AROUND * stress, below = stress / AROUND;
    return curve->count < 2
               ? 0.0
               : (clod_curve_at(curve, above) - clod_curve_at(curve, below)) / (above - below);
}

/** Largest error of the values, or of those at a stress where one is given. */
static double largest(const clod_curve *of, double stress)
{
    double most = 0.0;
    for (size_t k = 0; k < of->count; k++) {
        if (stress <= 0.0 || clod_plan_samples_same(of->points[k].x, stress)) {
            most = fmax(most, of->points[k].y_error);
        }
    }
    return most;
}

/** Points, each with the error of its value and of its stress together. */
static void take_points(const clod_curve *from, double error, clod_plan_samples *to)
{
    const clod_curve *curve = to->curve;
    const clod_curve_point *first = &curve->points[0], *last = &curve->points[curve->count - 1];
    to->slope = curve->count < 2 ? 0.0 : (last->y - first->y) / (last->x - first->x);
    for (size_t k = 0; k < from->count; k++) {
        const clod_curve_point *p = &from->points[k];
        const double stated = fmax(p->y_error, error);
        to->items[to->count++] = (clod_plan_sample){
            .stress = p->x,
            .value = p->y,
            .error = stated > 0.0 ? hypot(stated, slope_at(curve, p->x) * p->x_error) : 0.0};
    }
}

/** Whether the plan says which points are targets, and the table has them; else a complaint. */
static bool check_choice(maker *self, const clod_number *kind, const clod_plan_samples *points)
{
    const double wanted = self->wish->normal_stress;
    if (wanted <= 0.0 && (kind->at_stress || points->count == 1)) {
        return true;
    }
    char list[160];
    clod_text_names names = clod_text_names_begin(list, sizeof list);
    for (size_t k = 0; k < points->count; k++) {
        char one[32];
        snprintf(one, sizeof one, "%.6g", 1e-3 * points->items[k].stress);
        clod_text_names_add(&names, one);
        if (wanted > 0.0 && clod_plan_samples_same(points->items[k].stress, wanted)) {
            return true;
        }
    }
    clod_text_names_end(&names);
    if (wanted > 0.0) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "normal_stress"),
                        "%.6g kPa: the table has no such sigma_1; it has %s kPa", 1e-3 * wanted,
                        list);
    } else {
        clod_check_fail(
            self->loader, clod_plan_targets_at(self, ""),
            "needs the key normal_stress, the sigma_1 of the row that belongs to the preshear "
            "stress of test %s; the table has %s kPa",
            self->wish->test, list);
    }
    return false;
}

/**
 * Whether sigma_1 of a table can belong to a shear test with this preshear stress; else a complaint. It is the
 * largest stress of a circle through the preshear point, so never below the preshear stress.
 */
static bool check_consolidation(maker *self, size_t test, const clod_curve *curve)
{
    const clod_case_programme *shear = clod_case_shear(self->plan->tests[test].middle);
    const double preshear = shear != NULL ? shear->preshear_stress : 0.0;
    const double first = curve->points[0].x, last = curve->points[curve->count - 1].x;
    const bool below = last < preshear;
    if (shear == NULL || (!below && first <= MOST_OVER_PRESHEAR * preshear)) {
        return true;
    }
    clod_check_fail(
        self->loader, clod_plan_targets_at(self, "locus"),
        "%s sigma_1 of %.6g kPa, and test %s is presheared at %.6g kPa: its own sigma_1 is "
        "%s. Is the unit right? Else give the case a preshear stress that belongs to the table",
        below ? "ends at" : "begins at", 1e-3 * (below ? last : first), self->wish->test,
        1e-3 * preshear, below ? "above that" : "a few times that, not more than six");
    return false;
}

/** Warn where each stress has one row. Its errors may be of several specimens all the same. */
static void warn_single(maker *self, const clod_plan_target *common,
                        const clod_plan_samples *points, double stated)
{
    for (size_t k = 0; k < points->count; k++) {
        if (points->items[k].repeats.count > 1) {
            return;
        }
    }
    char text[160];
    snprintf(text, sizeof text,
             "one row at each stress: scatter between specimens not included, unless %s has it",
             points->error_column);
    clod_plan_samples_warn_one(self, common, stated, text);
}

/** Warn of densities in another unit. */
static void warn_light(maker *self, const clod_number *kind, const clod_curve *from)
{
    double least = HUGE_VAL;
    for (size_t k = 0; k < from->count; k++) {
        least = fmin(least, from->points[k].y);
    }
    char text[CLOD_LOCUS_WARNING_TEXT];
    if (strcmp(kind->unit, "kg/m3") == 0 && clod_bulk_density_warn(least, text)) {
        clod_plan_samples_warn(self, text);
    }
}

/** Targets of the points of a curve. */
static void make_targets(maker *self, size_t test, const clod_number *kind, clod_curve *from,
                         const char *error_column)
{
    clod_plan_target common;
    clod_plan_samples list;
    if (!clod_plan_samples_common(self, test, kind, &common)) {
        return;
    }
    if (from->count == 0) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "number"),
                        "%s: the table has no column with values of it", kind->key);
        return;
    }
    if (clod_plan_samples_init(&list, self, from->count)) {
        list.error_column = error_column;
        clod_curve_sort(from);
        list.curve = keep_curve(self, from);
        if (list.curve != NULL) {
            const double stated = largest(from, self->wish->normal_stress);
            take_points(from, common.error, &list);
            clod_plan_samples_merge(&list, 0.0);
            warn_single(self, &common, &list, stated);
            warn_light(self, kind, from);
        }
        if (list.curve != NULL && check_consolidation(self, test, list.curve) &&
            check_choice(self, kind, &list)) {
            clod_plan_samples_make(self, kind, &common, &list, self->wish->normal_stress);
        }
    }
    clod_plan_samples_fini(&list);
}

static bool make_density(maker *self, size_t test, const clod_number *kind, clod_status *status)
{
    clod_curve rho = {0};
    const bool good = clod_tables_read_density(self->wish->locus, &rho, status);
    if (good) {
        make_targets(self, test, kind, &rho, "rho_b_error");
    }
    clod_curve_fini(&rho);
    return good;
}

static bool make_flow(maker *self, size_t test, const clod_number *kind, clod_status *status)
{
    clod_solid solid = {0};
    const bool strength = strcmp(kind->key, "sigma_c") == 0;
    clod_tables_notes notes = {0};
    const bool good = clod_tables_read_flow(self->wish->locus, &solid, &notes, status);
    if (good) {
        make_targets(self, test, kind, strength ? &solid.strength : &solid.rho,
                     strength ? "sigma_c_error" : "rho_b_error");
    }
    clod_tables_fini(&solid);
    return good;
}

const clod_plan_table CLOD_PLAN_TABLE_DENSITY = {
    .is = CLOD_PLAN_IS_DENSITY, .numbers = {"rho_b"}, .one_stress = true, .make = make_density};

const clod_plan_table CLOD_PLAN_TABLE_FLOW = {.is = CLOD_PLAN_IS_FLOW,
                                              .numbers = {"sigma_c", "rho_b"},
                                              .one_stress = true,
                                              .make = make_flow};
