/**
 * @file plan_doubts_values.c
 * Single values that are possible and hardly meant, mostly for a wrong unit: warnings. What no solid can have is refused
 * (plan_targets.c, plan_conflicts_unit.c, plan_conflicts_shear.c).
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "calibrate/number.h"
#include "calibrate/plan_check.h"
#include "calibrate/test_kinds.h"

#define STEEP 60.0        ///< deg: hardly any solid is steeper, but for phi_e
#define THIRD (1.0 / 3.0) ///< of the grains' density
#define SURE 1e-3         ///< relative error that hardly anybody measures
#define SURE_MASS 1e-4    ///< that of densities, and of masses and times of free runs

// Solids flow with 20 deg at least, as a rule (spheres of glass, 22); 15 leaves room. Walls are smoother: PTFE has 3 deg.
typedef struct range {
    const char *number;
    double least, most; ///< deg
} range;

static const range ANGLES[] = {
    {"phi_lin", 15.0, STEEP}, {"phi_sf", 15.0, STEEP}, {"phi_e", 15.0, 75.0},
    {"tau", 15.0, STEEP},     {"tau_p", 15.0, STEEP},  {"phi_w", 3.0, STEEP},
    {"phi_x", 3.0, STEEP},
};

// Pa in place of kPa makes a thousandth, and c, sigma_2 and sigma_c are rarely above once or twice the preshear stress.
typedef struct floor_of {
    const char *number;
    double least; ///< over the stress of the test
} floor_of;

static const floor_of STRESSES[] = {
    {"c", 1e-3}, {"sigma_2", 1e-3}, {"sigma_c", 2e-3}, {"tau_ad", 1e-3}};

/** Stress that a test is known by: of preshear, of consolidation, the largest at a wall; 0: none. */
static double stress_of(const clod_plan_test *test, const clod_plan_target *of,
                        const char **name)
{
    const clod_number *numbers = clod_test_kinds_of(test->middle)->numbers;
    if (numbers == CLOD_NUMBERS_SHEAR) {
        *name = "preshear stress";
        return clod_case_shear(test->middle)->preshear_stress;
    }
    if (numbers == CLOD_NUMBERS_UNIAXIAL) {
        *name = "consolidation stress";
        return of->normal_stress;
    }
    double most = 0.0;
    const clod_case_wall_friction *wall = &test->middle->wall_friction;
    for (size_t k = 0; k < wall->wall_stress_count && numbers == CLOD_NUMBERS_WALL; k++) {
        most = fmax(most, wall->wall_stresses[k]);
    }
    *name = "largest wall stress";
    return most;
}

/** An angle, or that of a shear stress: over its normal stress where it is small, over the larger stress where not. */
static void warn_of_angle(clod_plan *self, const clod_plan_target *of, const range *limits)
{
    const clod_plan_test *test = &self->tests[of->test];
    const bool shear = strncmp(of->number, "tau", 3) == 0;
    double low = of->value, high = low;
    if (shear) {
        const double preshear = clod_case_shear(test->middle)->preshear_stress;
        const double stress = of->normal_stress > 0.0 ? of->normal_stress : preshear;
        low = atan(of->value / stress);
        high = atan(of->value / fmax(stress, preshear));
    }
    low /= CLOD_NUMBER_DEGREE;
    high /= CLOD_NUMBER_DEGREE;
    const bool flat = low < limits->least && of->value > of->error;
    if (!flat && high <= limits->most) {
        return;
    }
    char angle[48] = "";
    if (shear) {
        snprintf(angle, sizeof angle, ", %.3g deg of the normal stress", flat ? low : high);
    }
    clod_warning_list_add(&self->warnings,
                          "targets.%zu: %s, %.4g %s%s: hardly any %s has %s than %.0f deg. %s",
                          of->entry, of->name, of->measure.factor * of->value, of->measure.unit,
                          angle, limits->least < 15.0 ? "wall" : "solid",
                          flat ? "less" : "more", flat ? limits->least : limits->most,
                          shear  ? "Has it another unit, or the normal stress?"
                          : flat ? "Is it in rad?"
                                 : "Is it that of another stress?");
}

/** How many times its preshear stress a solid with an angle of steady flow up to phi_sf [rad] has at most of c, sigma_c or sigma_1;
 *  HUGE_VAL: of another number. */
static double most_stress(const char *number, double phi_sf)
{
    // The circle of steady flow goes through preshear. Its sigma_1 is largest with a cohesion of 0, sp/(1 - sin(phi_sf)). Without
    // tension c is at most the radius of the circle that ends at the origin, sp/(2 cos(phi_sf)^2), and sigma_c its diameter.
    const double steepest = cos(phi_sf) * cos(phi_sf);
    return strcmp(number, "c") == 0         ? 0.5 / steepest
           : strcmp(number, "sigma_c") == 0 ? 1.0 / steepest
           : strcmp(number, "sigma_1") == 0 ? 1.0 / (1.0 - sin(phi_sf))
                                            : HUGE_VAL;
}

static void warn_of_stress(clod_plan *self, const clod_plan_target *of, double least)
{
    const char *name;
    const clod_plan_test *test = &self->tests[of->test];
    const double stress = stress_of(test, of, &name);
    const bool shear = clod_test_kinds_of(test->middle)->numbers == CLOD_NUMBERS_SHEAR;
    const double most = shear ? most_stress(of->number, STEEP * CLOD_NUMBER_DEGREE) : 1.0;
    if (of->value > CLOD_PLAN_FIRM_ERRORS * of->error && of->value < least * stress) {
        clod_warning_list_add(
            &self->warnings,
            "targets.%zu: %s, %.4g kPa, is %.2g times the %s, %.4g kPa: next to none. Has it another unit? If next to "
            "none is meant, all is well",
            of->entry, of->name, 1e-3 * of->value, of->value / stress, name, 1e-3 * stress);
    } else if (of->value - most * stress > CLOD_PLAN_FIRM_ERRORS * of->error) {
        clod_warning_list_add(
            &self->warnings,
            "targets.%zu: %s, %.4g kPa, is %.3g times the %s, %.4g kPa, and hardly any solid or wall has more than %.4g kPa there: has "
            "it another unit, or is it of another stress?",
            of->entry, of->name, 1e-3 * of->value, of->value / stress, name, 1e-3 * stress,
            1e-3 * most * stress);
    }
}

static void warn_of_ffc(clod_plan *self, const clod_plan_target *of)
{
    if (1.0 - of->value > CLOD_PLAN_FIRM_ERRORS * of->error) {
        clod_warning_list_add(
            &self->warnings,
            "targets.%zu: %s, %.3g, is below 1: a strength above the stress that consolidated it, as of "
            "a solid that does not flow, or has set. Is it sigma_c/sigma_1?",
            of->entry, of->name, of->value);
    }
}

static void warn_of_density(clod_plan *self, const clod_plan_target *of)
{
    const double grains = clod_plan_grain_density(self, &self->tests[of->test], 0.0);
    if (of->value < THIRD * grains) {
        clod_warning_list_add(
            &self->warnings,
            "targets.%zu: %s, %.4g kg/m3, is below a third of the density of the grains, %.4g kg/m3: only fine "
            "powders that stick are as loose. Has it another unit?",
            of->entry, of->name, of->value, grains);
    }
}

static void warn_of_single(clod_plan *self, const clod_plan_target *of)
{
    for (size_t k = 0; k < sizeof ANGLES / sizeof ANGLES[0]; k++) {
        if (strcmp(of->number, ANGLES[k].number) == 0) {
            warn_of_angle(self, of, &ANGLES[k]);
        }
    }
    for (size_t k = 0; k < sizeof STRESSES / sizeof STRESSES[0]; k++) {
        if (strcmp(of->number, STRESSES[k].number) == 0) {
            warn_of_stress(self, of, STRESSES[k].least);
        }
    }
    if (strcmp(of->number, "sigma_1") == 0) {
        warn_of_stress(self, of, 0.0);
    } else if (strcmp(of->number, "ffc") == 0) {
        warn_of_ffc(self, of);
    } else if (strcmp(of->number, "rho_b") == 0 || strcmp(of->number, "rho_inside") == 0) {
        warn_of_density(self, of);
    }
}

/** An error as written in the plan; what the model misses is allowed for beside it. */
static void warn_of_error(clod_plan *self, const clod_plan_target *of)
{
    const double error = hypot(of->error, of->discrepancy);
    const bool mass = strncmp(of->number, "rho_", 4) == 0 ||
                      clod_test_kinds_of(self->tests[of->test].middle)->paths;
    if (error < (mass ? SURE_MASS : SURE) * fabs(of->value)) {
        const clod_plan_measure *unit = &of->measure;
        clod_warning_list_add(
            &self->warnings,
            "targets.%zu: the error of %s, %.3g %s, is %.2g of its value, less than specimens mostly differ by: it outweighs all "
            "other targets. Has it another unit, or none? Give what specimens differ by, or a discrepancy",
            of->entry, of->name, unit->factor * error, unit->unit, error / fabs(of->value));
    }
}

void clod_plan_warn_values(clod_plan *self)
{
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *of = &self->targets[k];
        const clod_plan_wish *wish = &self->wishes[of->entry];
        const bool free = clod_test_kinds_of(self->tests[of->test].middle)->paths;
        if (wish->locus == NULL && !free) {
            warn_of_single(self, of);
        }
        if (wish->error != NULL && (k == 0 || self->targets[k - 1].entry != of->entry)) {
            warn_of_error(self, of);
        }
    }
}
