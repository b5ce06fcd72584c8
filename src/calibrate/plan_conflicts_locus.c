/**
 * @file plan_conflicts_locus.c
 * A strength of one shear test that no straight yield locus has: too large for its other targets.
 */

#include <math.h>

#include "analysis/angles.h"
#include "analysis/mohr.h"
#include "calibrate/number.h"
#include "calibrate/plan_check.h"

#define FIRM CLOD_PLAN_FIRM_ERRORS

/** sqrt(a^2 + b^2 + c^2), as of errors. */
static double root(double a, double b, double c)
{
    return hypot(hypot(a, b), c);
}

/**
 * The circle of sigma_c ends at the origin and touches the same straight line as that of steady flow, which ends at
 * sigma_2 >= 0. With an angle of 0 or more it is not the larger one: sigma_c <= sigma_1 - sigma_2.
 */
static void check_circles(clod_loader *loader, const clod_plan *self, size_t test)
{
    const clod_plan_target *strength = clod_plan_conflicts_target(self, test, "sigma_c");
    const clod_plan_target *major = clod_plan_conflicts_target(self, test, "sigma_1");
    const clod_plan_target *minor = clod_plan_conflicts_target(self, test, "sigma_2");
    if (strength == NULL || major == NULL || minor == NULL) {
        return;
    }
    const double most = major->value - minor->value;
    if (strength->value - most > FIRM * root(clod_plan_conflicts_error(strength),
                                             clod_plan_conflicts_error(major),
                                             clod_plan_conflicts_error(minor))) {
        clod_check_fail(
            loader, "targets",
            "test %s: sigma_c %.4g kPa in targets.%zu is above sigma_1 - sigma_2 = %.4g kPa, of targets.%zu and "
            "targets.%zu, and no straight yield locus has more; correct or leave out one of them",
            self->tests[test].name, 1e-3 * strength->value, strength->entry, 1e-3 * most,
            major->entry, minor->entry);
    }
}

/** The same by phi_e: sigma_1 - sigma_2 = sigma_1 2 s/(1 + s), s = sin(phi_e). */
static void check_strength(clod_loader *loader, const clod_plan *self, size_t test)
{
    const clod_plan_target *strength = clod_plan_conflicts_target(self, test, "sigma_c");
    const clod_plan_target *major = clod_plan_conflicts_target(self, test, "sigma_1");
    const clod_plan_target *angle = clod_plan_conflicts_target(self, test, "phi_e");
    if (strength == NULL || major == NULL || angle == NULL) {
        return;
    }
    const double s = sin(angle->value);
    const double share = 2.0 * s / (1.0 + s);
    const double slope = 2.0 * cos(angle->value) / ((1.0 + s) * (1.0 + s)); // over the angle
    const double most = share * major->value;
    if (strength->value - most >
        FIRM * root(clod_plan_conflicts_error(strength),
                    share * clod_plan_conflicts_error(major),
                    slope * major->value * clod_plan_conflicts_error(angle))) {
        clod_check_fail(
            loader, "targets",
            "test %s: sigma_c %.4g kPa in targets.%zu is above sigma_1 2 sin(phi_e)/(1 + sin(phi_e)) = %.4g kPa, of "
            "sigma_1 %.4g kPa in targets.%zu and phi_e %.1f deg in targets.%zu, and no straight yield locus has "
            "more; correct or leave out one of them",
            self->tests[test].name, 1e-3 * strength->value, strength->entry, 1e-3 * most,
            1e-3 * major->value, major->entry, angle->measure.factor * angle->value,
            angle->entry);
    }
}

/** The same of ffc = sigma_1/sigma_c: with sigma_2 >= 0 it is 1 at least, and more of a known phi_e. */
static void check_least_ffc(clod_loader *loader, const clod_plan *self, size_t test)
{
    const clod_plan_target *ffc = clod_plan_conflicts_target(self, test, "ffc");
    const clod_plan_target *angle = clod_plan_conflicts_target(self, test, "phi_e");
    if (ffc != NULL && 1.0 - ffc->value > FIRM * clod_plan_conflicts_error(ffc)) {
        clod_check_fail(
            loader, "targets",
            "test %s: ffc %.4g in targets.%zu is below 1: sigma_c would be above sigma_1, and a straight yield locus "
            "has at most sigma_1 - sigma_2; correct it, or is it sigma_c/sigma_1?",
            self->tests[test].name, ffc->value, ffc->entry);
        return;
    }
    if (ffc == NULL || angle == NULL) {
        return;
    }
    const double s = sin(angle->value);
    const double least = (1.0 + s) / (2.0 * s);
    const double slope = cos(angle->value) / (2.0 * s * s); // over the angle, downwards
    if (least - ffc->value > FIRM * hypot(clod_plan_conflicts_error(ffc),
                                          slope * clod_plan_conflicts_error(angle))) {
        clod_check_fail(
            loader, "targets",
            "test %s: ffc %.4g in targets.%zu is below (1 + sin(phi_e))/(2 sin(phi_e)) = %.4g, of phi_e %.1f deg in "
            "targets.%zu, and no straight yield locus has less; correct or leave out one of them",
            self->tests[test].name, ffc->value, ffc->entry, least,
            angle->measure.factor * angle->value, angle->entry);
    }
}

/** sigma_c = 2 c cos(phi_lin)/(1 - sin(phi_lin)) = 2 c tan(45 deg + phi_lin/2), and phi_lin has a largest value. */
static void check_cohesion(clod_loader *loader, const clod_plan *self, size_t test)
{
    const clod_plan_target *cohesion = clod_plan_conflicts_target(self, test, "c");
    const clod_plan_target *strength = clod_plan_conflicts_target(self, test, "sigma_c");
    if (cohesion == NULL || strength == NULL) {
        return;
    }
    const double times = clod_mohr_unconfined(1.0, tan(CLOD_ANGLES_MOST * CLOD_NUMBER_DEGREE));
    const double most = times * cohesion->value;
    if (strength->value - most > FIRM * hypot(clod_plan_conflicts_error(strength),
                                              times * clod_plan_conflicts_error(cohesion))) {
        clod_check_fail(
            loader, "targets",
            "test %s: sigma_c %.4g kPa in targets.%zu is too large for c %.4g kPa in targets.%zu: "
            "sigma_c = 2 c cos(phi_lin)/(1 - sin(phi_lin)) is %.4g kPa with phi_lin %.0f deg, the largest that clod "
            "locus takes; correct or leave out one of them",
            self->tests[test].name, 1e-3 * strength->value, strength->entry,
            1e-3 * cohesion->value, cohesion->entry, 1e-3 * most, CLOD_ANGLES_MOST);
    }
}

void clod_plan_conflicts_locus(clod_loader *loader, const clod_plan *self, size_t test)
{
    check_circles(loader, self, test);
    check_strength(loader, self, test);
    check_least_ffc(loader, self, test);
    check_cohesion(loader, self, test);
}
