/**
 * @file plan_tables.c
 * Targets of a plan from measured tables: yield loci of shear tests, wall yield loci.
 */

#include <math.h>
#include <string.h>

#include "calibrate/plan_targets.h"
#include "clod/locus.h"
#include "clod/wall_locus.h"

typedef clod_plan_maker maker;

/** A measured point. */
typedef struct sample {
    double stress, value, error; ///< SI; error 0: the table has none
} sample;

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

/** A measured point as a target. */
static void make_point(maker *self, const clod_number *kind, const clod_plan_target *common,
                       sample point)
{
    clod_plan_target made = *common;
    made.normal_stress = point.stress;
    made.value = point.value;
    made.error = point.error > 0.0 ? point.error : common->error;
    if (made.error <= 0.0) {
        clod_plan_complain(self->loader, clod_plan_targets_at(self, ""),
                           "needs the key error: the table has no %s at %.6g kPa",
                           strcmp(kind->key, "tau") == 0 ? "tau_sh_error" : "tau_w_error",
                           1e-3 * point.stress);
    } else if (made.value < kind->least || made.value > kind->most) {
        clod_plan_complain(self->loader, clod_plan_targets_at(self, "locus"),
                           "has a %s of %.6g %s at %.6g kPa; allowed is %.6g to %.6g %s",
                           kind->key, kind->measure.factor * made.value, kind->measure.unit,
                           1e-3 * point.stress, kind->measure.factor * kind->least,
                           kind->measure.factor * kind->most, kind->measure.unit);
    } else if (clod_plan_targets_check_stress(self, made.test, kind, kind->key, point.stress)) {
        clod_plan_targets_add(self, &made, kind->key);
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

/** Points of the locus with the preshear stress of the test. */
static void make_marks(maker *self, size_t test, const clod_locus_study *study,
                       const clod_locus_point *points, size_t count)
{
    const clod_number *kind = clod_number_find(CLOD_CASE_RING_SHEAR, "tau");
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
        for (size_t k = 0; k < locus->point_count; k++) {
            const clod_locus_mark *mark = &locus->marks[k];
            make_point(self, kind, &common,
                       (sample){mark->sigma, mark->prorated, error_of(mark, points, count)});
        }
        return;
    }
    clod_plan_complain(self->loader, clod_plan_targets_at(self, "locus"),
                       "has no points with the preshear stress of test %s, %.6g kPa",
                       self->wish->test, 1e-3 * preshear);
}

/** The points of a measured yield locus; false with status. */
static bool make_locus(maker *self, size_t test, clod_status *status)
{
    clod_locus_point *points;
    size_t count;
    if (!clod_locus_read(self->wish->locus, NULL, &points, &count, status)) {
        return false;
    }
    clod_locus_study *study = clod_locus_study_create(points, count, status);
    const bool good = study != NULL;
    if (good) {
        make_marks(self, test, study, points, count);
    }
    clod_locus_study_destroy(&study);
    clod_locus_free(points);
    return good;
}

// ---- wall friction tests

/** phi_x of each point of a wall yield locus, or of those at the wish's normal stress. */
static void make_angles(maker *self, size_t test, const clod_wall_locus *locus)
{
    const clod_number *kind = clod_number_find(CLOD_CASE_WALL_FRICTION, "phi_x");
    const double wanted = self->wish->normal_stress;
    size_t found = 0;
    clod_plan_target common;
    if (!common_of(self, test, kind, &common)) {
        return;
    }
    for (size_t k = 0; k < locus->point_count; k++) {
        const clod_wall_locus_mark *mark = &locus->marks[k];
        const clod_wall_locus_point *of = &mark->point;
        const double stress = of->wall_stress > 0.0 ? of->wall_stress : of->sigma;
        if (wanted > 0.0 && fabs(stress / wanted - 1.0) >= CLOD_NUMBER_SAME_STRESS) {
            continue;
        }
        found++;
        if (of->unsteady) {
            clod_plan_complain(self->loader, clod_plan_targets_at(self, "locus"),
                               "was not steady at %.6g kPa, and phi_x there is none of steady "
                               "shear; leave that point out",
                               1e-3 * stress);
            continue;
        }
        make_point(self, kind, &common,
                   (sample){stress, mark->phi_x.value,
                            isfinite(mark->phi_x.error) ? mark->phi_x.error : 0.0});
    }
    if (found == 0) {
        clod_plan_complain(self->loader, clod_plan_targets_at(self, "normal_stress"),
                           "%.6g kPa: the table has no point there", 1e-3 * wanted);
    }
}

/** The points of a measured wall yield locus; false with status. */
static bool make_wall(maker *self, size_t test, clod_status *status)
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
        make_angles(self, test, &locus);
        clod_wall_locus_fini(&locus);
    }
    return good;
}

void clod_plan_tables_make(clod_plan_maker *self, size_t test)
{
    const clod_plan_wish *wish = self->wish;
    const clod_case *from = self->plan->tests[test].middle;
    const bool wall = clod_case_kind_of(from) == CLOD_CASE_WALL_FRICTION;
    if (!wall && clod_case_shear(from) == NULL) {
        clod_plan_complain(self->loader, clod_plan_targets_at(self, "locus"),
                           "test %s is neither a shear test nor a wall friction test; give "
                           "number and value",
                           wish->test);
        return;
    }
    if (wish->number != NULL || wish->value != NULL || (!wall && wish->normal_stress > 0.0)) {
        clod_plan_complain(self->loader, clod_plan_targets_at(self, "locus"),
                           "has number%s beside it; the table has them all",
                           wall ? " or value" : ", value or normal_stress");
        return;
    }
    clod_status status = {CLOD_OK, ""};
    const bool good = wall ? make_wall(self, test, &status) : make_locus(self, test, &status);
    if (!good) {
        clod_plan_complain(self->loader, clod_plan_targets_at(self, "locus"), "%.800s",
                           status.text);
    }
}
