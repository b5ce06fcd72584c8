/**
 * @file plan_conflicts.c
 * Targets that cannot be true together.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "calibrate/number.h"
#include "calibrate/plan_loci.h"
#include "calibrate/test_kinds.h"
#include "config/testers.h"

#define FIRM CLOD_PLAN_FIRM_ERRORS

/** Target of a test with this number, or NULL. */
static const clod_plan_target *with(const clod_plan *self, size_t test, const char *number)
{
    for (size_t k = 0; k < self->target_count; k++) {
        if (self->targets[k].test == test && strcmp(self->targets[k].number, number) == 0) {
            return &self->targets[k];
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
    {"sigma_2", "sigma_1", 1.0, "the major principal stress"},
};

static void check_order(clod_loader *loader, const clod_plan *self, size_t test,
                        const order *of)
{
    const clod_plan_target *less = with(self, test, of->less);
    const clod_plan_target *more = with(self, test, of->more);
    if (less == NULL || more == NULL || more->curve != NULL ||
        of->times * less->value - more->value <=
            FIRM * hypot(of->times * less->error, more->error)) {
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

/** sigma_1 is the right end of a circle through preshear, and tan(phi_sf) is tau_p over its stress. */
static void check_preshear(clod_loader *loader, const clod_plan *self, size_t test)
{
    const double stress = clod_case_shear(self->tests[test].middle)->preshear_stress;
    const clod_plan_target *major = with(self, test, "sigma_1");
    if (major != NULL && stress - major->value > FIRM * major->error) {
        clod_check_fail(
            loader, "targets",
            "test %s: sigma_1 %.4g kPa in targets.%zu is below the preshear stress of the case, "
            "%.4g kPa: no circle through preshear ends there; give the sigma_1 of that "
            "consolidation, or the test its preshear stress",
            self->tests[test].name, 1e-3 * major->value, major->entry, 1e-3 * stress);
    }
    const clod_plan_target *angle = with(self, test, "phi_sf");
    const clod_plan_target *shear = with(self, test, "tau_p");
    if (angle == NULL || shear == NULL) {
        return;
    }
    const double of_shear = atan2(shear->value, stress);
    const double slope =
        stress / (stress * stress + shear->value * shear->value); // of the angle over tau_p
    if (fabs(of_shear - angle->value) > FIRM * hypot(angle->error, slope * shear->error)) {
        clod_check_fail(
            loader, "targets",
            "test %s: phi_sf %.1f deg in targets.%zu is not that of tau_p %.4g kPa in targets.%zu "
            "at the preshear stress of the case, %.4g kPa: %.1f deg; they contradict each other",
            self->tests[test].name, angle->measure.factor * angle->value, angle->entry,
            1e-3 * shear->value, shear->entry, 1e-3 * stress, angle->measure.factor * of_shear);
    }
}

static void check_shear_tests(clod_loader *loader, const clod_plan *self)
{
    for (size_t t = 0; t < self->test_count; t++) {
        if (clod_test_kinds_of(self->tests[t].middle)->numbers != CLOD_NUMBERS_SHEAR) {
            continue;
        }
        for (size_t k = 0; k < sizeof ORDERS / sizeof ORDERS[0]; k++) {
            check_order(loader, self, t, &ORDERS[k]);
        }
        check_preshear(loader, self, t);
    }
}

/** The same number twice: once is enough, or the values are two specimens'. */
static void check_twice(clod_loader *loader, const clod_plan *self)
{
    for (size_t k = 0; k < self->target_count; k++) {
        for (size_t m = 0; m < k; m++) {
            const clod_plan_target *a = &self->targets[m];
            const clod_plan_target *b = &self->targets[k];
            const double apart = fabs(a->value - b->value) / hypot(a->error, b->error);
            if (strcmp(a->name, b->name) == 0 && apart > CLOD_PLAN_SAME_ERRORS) {
                clod_check_fail(
                    loader, "targets",
                    "%s is there as %.6g %s in targets.%zu and as %.6g %s in targets.%zu, %.1f standard errors "
                    "apart: they contradict each other; leave one of them out, or give the errors that "
                    "specimens differ by",
                    a->name, a->measure.factor * a->value, a->measure.unit, a->entry,
                    b->measure.factor * b->value, b->measure.unit, b->entry, apart);
            }
        }
    }
}

// ---- ffc

static bool is(const clod_plan_target *self, size_t test, const char *number)
{
    return self->test == test && strcmp(self->number, number) == 0;
}

/** A stress and how well it is known. */
typedef struct known {
    double value, error;
    const clod_plan_target *from; ///< NULL: the stress of the test itself
} known;

/** ffc = sigma_1/sigma_c, as sigma_c ffc = sigma_1, which holds for sigma_c = 0, too. */
static void compare_ffc(clod_loader *loader, const clod_plan *self, const clod_plan_target *ffc,
                        const clod_plan_target *strength, const known *sigma_1)
{
    const double product = ffc->value * strength->value;
    const double error = sqrt(ffc->error * ffc->error * strength->value * strength->value +
                              ffc->value * ffc->value * strength->error * strength->error +
                              sigma_1->error * sigma_1->error);
    const double apart = fabs(product - sigma_1->value) / error;
    if (apart <= FIRM) {
        return;
    }
    char place[48] = "the consolidation stress";
    if (sigma_1->from != NULL) {
        snprintf(place, sizeof place, "sigma_1 in targets.%zu", sigma_1->from->entry);
    }
    clod_check_fail(
        loader, "targets",
        "test %s: ffc %.4g in targets.%zu is not sigma_1/sigma_c = %.4g kPa/%.4g kPa, of %s "
        "and sigma_c in targets.%zu, by %.1f standard errors: they contradict each other; "
        "correct or leave out one of them",
        self->tests[ffc->test].name, ffc->value, ffc->entry, 1e-3 * sigma_1->value,
        1e-3 * strength->value, place, strength->entry, apart);
}

/** ffc and sigma_c of one consolidation with each sigma_1 that the plan has of it. */
static void compare_with(clod_loader *loader, const clod_plan *self,
                         const clod_plan_target *ffc, const clod_plan_target *strength)
{
    if (ffc->normal_stress > 0.0) { // that of a lid, which is sigma_1
        if (fabs(ffc->normal_stress / strength->normal_stress - 1.0) <
            CLOD_NUMBER_SAME_STRESS) {
            const double stress = ffc->normal_stress;
            compare_ffc(loader, self, ffc, strength,
                        &(known){stress, CLOD_NUMBER_SAME_STRESS * stress, NULL});
        }
        return;
    }
    for (size_t k = 0; k < self->target_count && strength->curve == NULL; k++) {
        const clod_plan_target *one = &self->targets[k];
        if (is(one, ffc->test, "sigma_1")) {
            compare_ffc(loader, self, ffc, strength, &(known){one->value, one->error, one});
        }
    }
}

static void check_ffc(clod_loader *loader, const clod_plan *self)
{
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *ffc = &self->targets[k];
        for (size_t m = 0; m < self->target_count && strcmp(ffc->number, "ffc") == 0; m++) {
            if (is(&self->targets[m], ffc->test, "sigma_c")) {
                compare_with(loader, self, ffc, &self->targets[m]);
            }
        }
    }
}

// ---- density

/** The largest density of the grains of a test that the ranges allow; NAN: not known, as without memory. */
static double solid_density(const clod_plan *self, const clod_plan_test *test)
{
    double place[CLOD_PLAN_PARAMETERS]; // a density among the parameters is largest at its end
    for (size_t k = 0; k < CLOD_PLAN_PARAMETERS; k++) {
        place[k] = 1.0;
    }
    clod_status status = {CLOD_OK, ""};
    clod_case *dense = clod_plan_case(self, test, place, &status); // a corner, which did load
    double density = (double)NAN;
    if (dense != NULL) {
        const char *grain = clod_config_tester_of(dense)->materials(dense).grain;
        density = dense->materials[clod_case_material_index(dense, grain)].density;
    }
    clod_case_destroy(&dense);
    return density;
}

static bool is_density(const clod_plan_target *self, size_t test)
{
    return is(self, test, "rho_b") || is(self, test, "rho_inside");
}

static void check_density(clod_loader *loader, const clod_plan *self)
{
    for (size_t t = 0; t < self->test_count; t++) {
        double solid = (double)NAN;
        for (size_t k = 0; k < self->target_count; k++) {
            const clod_plan_target *one = &self->targets[k];
            if (!is_density(one, t) || clod_test_kinds_of(self->tests[t].middle)->paths) {
                continue;
            }
            solid = isnan(solid) ? solid_density(self, &self->tests[t]) : solid;
            if (one->value > solid) {
                clod_check_fail(
                    loader, "targets",
                    "test %s: %s %.0f kg/m3 in targets.%zu is above the density of its grains, %.0f "
                    "kg/m3, which no packing of them reaches; the case needs the density of the solid, and "
                    "the target that of the bulk",
                    self->tests[t].name, one->number, one->value, one->entry, solid);
            }
        }
    }
}

void clod_plan_check_conflicts(clod_loader *loader, const clod_plan *self)
{
    check_shear_tests(loader, self);
    check_twice(loader, self);
    clod_plan_loci_check(loader, self);
    check_ffc(loader, self);
    check_density(loader, self);
}
