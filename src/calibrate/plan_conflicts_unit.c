/**
 * @file plan_conflicts_unit.c
 * Stresses that no solid has at the preshear stress of their test: mostly a wrong unit.
 */

#include <math.h>
#include <string.h>

#include "analysis/angles.h"
#include "calibrate/number.h"
#include "calibrate/plan_check.h"
#include "calibrate/test_kinds.h"

/**
 * The circle of steady flow goes through preshear and ends at sigma_2 >= 0, so its radius is at most sp/(2 cos(phi_sf)^2)
 * (plan_conflicts_shear.c), 16.6 sp with the largest phi_sf that is taken. c is at most the radius, and sigma_1 and
 * sigma_c are at most the diameter.
 */
static double most_radii(const char *number)
{
    return strcmp(number, "c") == 0                                           ? 1.0
           : strcmp(number, "sigma_1") == 0 || strcmp(number, "sigma_c") == 0 ? 2.0
                                                                              : HUGE_VAL;
}

void clod_plan_conflicts_unit(clod_loader *loader, const clod_plan *self)
{
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *of = &self->targets[k];
        const clod_plan_test *test = &self->tests[of->test];
        if (clod_test_kinds_of(test->middle)->numbers != CLOD_NUMBERS_SHEAR ||
            of->curve != NULL) {
            continue;
        }
        const double stress = clod_case_shear(test->middle)->preshear_stress;
        const double steepest = cos(CLOD_ANGLES_MOST * CLOD_NUMBER_DEGREE);
        const double most = most_radii(of->number) * 0.5 * stress / (steepest * steepest);
        if (of->value - most > CLOD_PLAN_FIRM_ERRORS * of->error) {
            clod_check_fail(
                loader, "targets",
                "test %s: %s %.4g kPa in targets.%zu is %.3g times the preshear stress of the case, %.4g kPa, where no "
                "solid with phi_sf up to %.0f deg has more than %.3g times: check its unit, or give the test the "
                "preshear stress of that %s",
                test->name, of->number, 1e-3 * of->value, of->entry, of->value / stress,
                1e-3 * stress, CLOD_ANGLES_MOST, most / stress, of->number);
        }
    }
}
