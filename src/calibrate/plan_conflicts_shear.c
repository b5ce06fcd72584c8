/**
 * @file plan_conflicts_shear.c
 * Targets of one shear test that cannot be true together.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/angles.h"
#include "calibrate/number.h"
#include "calibrate/plan_check.h"
#include "calibrate/test_kinds.h"

#define FIRM CLOD_PLAN_FIRM_ERRORS

const clod_plan_target *clod_plan_conflicts_target(const clod_plan *self, size_t test,
                                                   const char *number)
{
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *one = &self->targets[k];
        if (one->test == test && one->curve == NULL && strcmp(one->number, number) == 0) {
            return one;
        }
    }
    return NULL;
}

/** Two numbers of a shear test of which one is at least so many times the other. */
typedef struct order {
    const char *less, *more;
    double times;
    const char *why;
} order;

// The steady circle goes through preshear and touches the yield locus; phi_e is the steepest line through the
// origin that meets it, and touches it too.
static const order ORDERS[] = {
    {"phi_lin", "phi_e", 1.0, "which no yield locus with a cohesion of 0 or more can have"},
    {"phi_sf", "phi_e", 1.0,
     "which is the steepest line through the origin that meets the circle of steady flow"},
    {"c", "sigma_c", 2.0,
     "and sigma_c = 2 c cos(phi_lin)/(1 - sin(phi_lin)) is not below 2 c at any angle"},
    {"c", "sigma_1", 2.0,
     "and sigma_1 is not below sigma_c, nor that below 2 c, unless steady flow reaches into tension"},
    {"sigma_2", "sigma_1", 1.0, "the major principal stress"},
    {"sigma_c", "sigma_1", 1.0,
     "and a straight yield locus has a sigma_c of at most sigma_1 - sigma_2, unless steady flow reaches into tension"},
};

static void check_order(clod_loader *loader, const clod_plan *self, size_t test,
                        const order *of)
{
    const clod_plan_target *less = clod_plan_conflicts_target(self, test, of->less);
    const clod_plan_target *more = clod_plan_conflicts_target(self, test, of->more);
    if (less == NULL || more == NULL ||
        of->times * less->value - more->value <=
            FIRM * hypot(of->times * clod_plan_conflicts_error(less),
                         clod_plan_conflicts_error(more))) {
        return;
    }
    const clod_plan_measure *unit = &more->measure;
    clod_check_fail(
        loader, "targets",
        "test %s: %s %.*f %s in targets.%zu is below %s%s %.*f %s in targets.%zu, %s; are "
        "they interchanged, or of different consolidations?",
        self->tests[test].name, of->more, unit->digits, unit->factor * more->value, unit->unit,
        more->entry, of->times > 1.0 ? "twice the " : "", of->less, unit->digits,
        unit->factor * less->value, unit->unit, less->entry, of->why);
}

/** sigma_2 and sigma_1 are the ends of a circle through preshear. */
static void check_ends(clod_loader *loader, const clod_plan *self, size_t test, double stress)
{
    const clod_plan_target *major = clod_plan_conflicts_target(self, test, "sigma_1");
    if (major != NULL && stress - major->value > FIRM * clod_plan_conflicts_error(major)) {
        clod_check_fail(
            loader, "targets",
            "test %s: sigma_1 %.4g kPa in targets.%zu is below the preshear stress of the case, "
            "%.4g kPa: no circle through preshear ends there; give the sigma_1 of that "
            "consolidation, or the test its preshear stress",
            self->tests[test].name, 1e-3 * major->value, major->entry, 1e-3 * stress);
    }
    const clod_plan_target *minor = clod_plan_conflicts_target(self, test, "sigma_2");
    if (minor != NULL && minor->value - stress > FIRM * clod_plan_conflicts_error(minor)) {
        clod_check_fail(
            loader, "targets",
            "test %s: sigma_2 %.4g kPa in targets.%zu is above the preshear stress of the case, "
            "%.4g kPa: no circle through preshear begins there; give the sigma_2 of that "
            "consolidation, or the test its preshear stress",
            self->tests[test].name, 1e-3 * minor->value, minor->entry, 1e-3 * stress);
    }
}

/** The slope of steady flow, phi_sf: a target, or what a target tau_p says of it. */
typedef struct steady {
    double angle, error; ///< rad
    const clod_plan_target *from;
    char words[96]; ///< "tau_p 37.4 kPa in targets.0"
} steady;

/** tan(phi_sf) is tau_p over the stress of preshear. False: there is no such target. */
static bool find_steady(const clod_plan *self, size_t test, const char *number, double stress,
                        steady *to)
{
    const clod_plan_target *from = clod_plan_conflicts_target(self, test, number);
    if (from == NULL) {
        return false;
    }
    *to = (steady){from->value, clod_plan_conflicts_error(from), from, ""};
    if (strcmp(number, "tau_p") == 0) {
        to->angle = atan2(from->value, stress);
        to->error = clod_plan_conflicts_error(from) * stress /
                    (stress * stress + from->value * from->value);
    }
    snprintf(to->words, sizeof to->words, "%s %.4g %s in targets.%zu", number,
             from->measure.factor * from->value, from->measure.unit, from->entry);
    return true;
}

/** A tau_p has the limits of its phi_sf, which is not above phi_e. */
static void check_tau_p(clod_loader *loader, const clod_plan *self, size_t test, double stress)
{
    steady of;
    if (!find_steady(self, test, "tau_p", stress, &of)) {
        return;
    }
    const double degrees = of.angle / CLOD_NUMBER_DEGREE;
    if (!(degrees >= CLOD_ANGLES_LEAST && degrees <= CLOD_ANGLES_MOST)) {
        clod_check_fail(
            loader, "targets",
            "test %s: %s is a phi_sf of %.1f deg at the preshear stress of the case, %.4g kPa; it must be %.0f to "
            "%.0f deg: check its unit, or give the test the preshear stress of that tau_p",
            self->tests[test].name, of.words, degrees, 1e-3 * stress, CLOD_ANGLES_LEAST,
            CLOD_ANGLES_MOST);
    }
    const clod_plan_target *angle = clod_plan_conflicts_target(self, test, "phi_e");
    if (angle != NULL &&
        of.angle - angle->value > FIRM * hypot(of.error, clod_plan_conflicts_error(angle))) {
        clod_check_fail(
            loader, "targets",
            "test %s: phi_e %.1f deg in targets.%zu is below phi_sf %.1f deg, which %s is at the preshear stress of "
            "the case, %.4g kPa; phi_e is the steepest line through the origin that meets the circle of steady flow",
            self->tests[test].name, angle->measure.factor * angle->value, angle->entry, degrees,
            of.words, 1e-3 * stress);
    }
}

/**
 * The circle of steady flow goes through preshear, on the side of sigma_1 from where it touches the yield locus, and ends
 * at sigma_2 >= 0. Its radius is then at most that of the circle from the origin, sp/(2 cos(phi_sf)^2), and a line that
 * touches it and does not fall has at most the radius as its cohesion.
 */
static void check_most_cohesion(clod_loader *loader, const clod_plan *self, size_t test,
                                const char *number, double stress)
{
    steady of;
    const clod_plan_target *cohesion = clod_plan_conflicts_target(self, test, "c");
    if (cohesion == NULL || !find_steady(self, test, number, stress, &of)) {
        return;
    }
    const double t = tan(of.angle);
    const double most = 0.5 * stress * (1.0 + t * t);
    const double error = stress * t * (1.0 + t * t) * of.error;
    if (cohesion->value - most > FIRM * hypot(clod_plan_conflicts_error(cohesion), error)) {
        clod_check_fail(
            loader, "targets",
            "test %s: c %.4g kPa in targets.%zu is too large for %s: with the preshear stress of the case, %.4g kPa, "
            "steady flow that does not reach into tension has a c of at most %.4g kPa; correct or leave out one of "
            "them",
            self->tests[test].name, 1e-3 * cohesion->value, cohesion->entry, of.words,
            1e-3 * stress, 1e-3 * most);
    }
}

/**
 * sigma_1 grows with the circle of steady flow through preshear: it is least where sigma_2 is 0, sp/cos(phi_sf)^2, and
 * most where the cohesion is, sp/(1 - sin(phi_sf)).
 */
static void check_major(clod_loader *loader, const clod_plan *self, size_t test,
                        const char *number, double stress)
{
    steady of;
    const clod_plan_target *major = clod_plan_conflicts_target(self, test, "sigma_1");
    if (major == NULL || !find_steady(self, test, number, stress, &of)) {
        return;
    }
    const double s = sin(of.angle), c = cos(of.angle);
    const double least = stress / (c * c), most = stress / (1.0 - s);
    const double least_error = 2.0 * least * s / c * of.error; // derivatives over the angle
    const double most_error = most * c / (1.0 - s) * of.error;
    if (least - major->value > FIRM * hypot(clod_plan_conflicts_error(major), least_error) ||
        major->value - most > FIRM * hypot(clod_plan_conflicts_error(major), most_error)) {
        clod_check_fail(
            loader, "targets",
            "test %s: sigma_1 %.4g kPa in targets.%zu does not go with %s: at the preshear stress of the case, %.4g kPa, "
            "circles of steady flow with a cohesion and a sigma_2 of 0 or more have %.4g to %.4g kPa; check units, or "
            "correct or leave out one of them",
            self->tests[test].name, 1e-3 * major->value, major->entry, of.words, 1e-3 * stress,
            1e-3 * least, 1e-3 * most);
    }
}

/** What goes with the stress of preshear. */
static void check_preshear(clod_loader *loader, const clod_plan *self, size_t test)
{
    const double stress = clod_case_shear(self->tests[test].middle)->preshear_stress;
    steady angle, shear;
    check_ends(loader, self, test, stress);
    check_tau_p(loader, self, test, stress);
    check_most_cohesion(loader, self, test, "tau_p", stress);
    check_most_cohesion(loader, self, test, "phi_sf", stress);
    check_major(loader, self, test, "tau_p", stress);
    check_major(loader, self, test, "phi_sf", stress);
    if (find_steady(self, test, "phi_sf", stress, &angle) &&
        find_steady(self, test, "tau_p", stress, &shear) &&
        fabs(shear.angle - angle.angle) > FIRM * hypot(angle.error, shear.error)) {
        clod_check_fail(
            loader, "targets",
            "test %s: phi_sf %.1f deg in targets.%zu is not that of %s "
            "at the preshear stress of the case, %.4g kPa: %.1f deg; they contradict each other",
            self->tests[test].name, angle.angle / CLOD_NUMBER_DEGREE, angle.from->entry,
            shear.words, 1e-3 * stress, shear.angle / CLOD_NUMBER_DEGREE);
    }
}

// ---- points of the line

/** Whether it is a shear stress of the line that was given as a number. */
static bool is_point(const clod_plan *self, size_t test, const clod_plan_target *target)
{
    return target->test == test && strcmp(target->number, "tau") == 0 &&
           self->wishes[target->entry].locus == NULL;
}

/** Shear stresses of one line rise with the normal stress; of a table the line itself is looked at (clod locus). */
static void check_points(clod_loader *loader, const clod_plan *self, size_t test)
{
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *low = &self->targets[k];
        for (size_t m = 0; m < self->target_count && is_point(self, test, low); m++) {
            const clod_plan_target *high = &self->targets[m];
            if (is_point(self, test, high) && high->normal_stress > low->normal_stress &&
                low->value - high->value > FIRM * hypot(clod_plan_conflicts_error(low),
                                                        clod_plan_conflicts_error(high))) {
                clod_check_fail(
                    loader, "targets",
                    "test %s: tau falls from %.4g kPa at %.4g kPa in targets.%zu to %.4g kPa at %.4g kPa in "
                    "targets.%zu, and a yield locus rises with the normal stress; are the stresses interchanged, "
                    "or of different consolidations?",
                    self->tests[test].name, 1e-3 * low->value, 1e-3 * low->normal_stress,
                    low->entry, 1e-3 * high->value, 1e-3 * high->normal_stress, high->entry);
            }
        }
    }
}

void clod_plan_conflicts_shear(clod_loader *loader, clod_plan *self)
{
    for (size_t t = 0; t < self->test_count; t++) {
        if (clod_test_kinds_of(self->tests[t].middle)->numbers != CLOD_NUMBERS_SHEAR) {
            continue;
        }
        const size_t before = loader->report->count;
        for (size_t k = 0; k < sizeof ORDERS / sizeof ORDERS[0]; k++) {
            check_order(loader, self, t, &ORDERS[k]);
        }
        check_preshear(loader, self, t);
        check_points(loader, self, t);
        clod_plan_conflicts_locus(loader, self, t);
        if (loader->report->count == before) { // else it would say the same again
            clod_plan_conflicts_identities(loader, self, t);
        }
    }
}
