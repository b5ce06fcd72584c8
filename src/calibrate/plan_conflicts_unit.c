/**
 * @file plan_conflicts_unit.c
 * Values that no solid has at the stress of their test: mostly a wrong unit.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/angles.h"
#include "calibrate/number.h"
#include "calibrate/plan_check.h"
#include "calibrate/test_kinds.h"

#define CEMENTED                                                                               \
    10.0 ///< times the stress that consolidated it: such a strength has another origin

/** A tau_p has the limits of its phi_sf. */
static void check_tau_p(clod_loader *loader, const clod_plan_test *test,
                        const clod_plan_target *of, double preshear)
{
    const double degrees = atan2(of->value, preshear) / CLOD_NUMBER_DEGREE;
    if (!(degrees >= CLOD_ANGLES_LEAST && degrees <= CLOD_ANGLES_MOST)) {
        clod_check_fail(
            loader, "targets",
            "test %s: tau_p %.4g kPa in targets.%zu is a phi_sf of %.1f deg at the preshear stress of the case, %.4g "
            "kPa; it must be %.0f to %.0f deg: check its unit, or give the test the preshear stress of that tau_p",
            test->name, 1e-3 * of->value, of->entry, degrees, 1e-3 * preshear,
            CLOD_ANGLES_LEAST, CLOD_ANGLES_MOST);
    }
}

/** A shear stress of the yield locus, given as a number: it rises from the normal stress, and up to preshear. */
static void check_shear_stress(clod_loader *loader, const clod_plan *self,
                               const clod_plan_target *of, double preshear)
{
    const double least = of->normal_stress * tan(CLOD_ANGLES_LEAST * CLOD_NUMBER_DEGREE);
    const double most =
        fmax(of->normal_stress, preshear) * tan(CLOD_ANGLES_MOST * CLOD_NUMBER_DEGREE);
    if (self->wishes[of->entry].locus == NULL && !(of->value >= least && of->value <= most)) {
        char path[48];
        snprintf(path, sizeof path, "targets.%zu.value", of->entry);
        clod_check_fail(
            loader, path,
            "tau %.4g kPa at a normal stress of %.4g kPa and a preshear stress of %.4g kPa: it must be %.4g kPa to %.4g "
            "kPa, %.0f deg of the normal stress to %.0f deg of the larger of both; check the units of tau and normal_stress",
            1e-3 * of->value, 1e-3 * of->normal_stress, 1e-3 * preshear, 1e-3 * least,
            1e-3 * most, CLOD_ANGLES_LEAST, CLOD_ANGLES_MOST);
    }
}

/** sigma_c of a uniaxial test over the stress that consolidated it, or ffc as the reverse. */
static void check_cemented(clod_loader *loader, const clod_plan_test *test,
                           const clod_plan_target *of)
{
    const double stress = of->normal_stress;
    if (strcmp(of->number, "sigma_c") == 0 &&
        of->value - CEMENTED * stress > CLOD_PLAN_FIRM_ERRORS * of->error) {
        clod_check_fail(
            loader, "targets",
            "test %s: sigma_c %.4g kPa in targets.%zu is %.3g times the stress that consolidates it, %.4g kPa, and what "
            "is pressed alone does not get %.0f times as strong: check its unit, or give the stress of that sigma_c",
            test->name, 1e-3 * of->value, of->entry, of->value / stress, 1e-3 * stress,
            CEMENTED);
    } else if (strcmp(of->number, "ffc") == 0 &&
               1.0 / CEMENTED - of->value > CLOD_PLAN_FIRM_ERRORS * of->error) {
        clod_check_fail(
            loader, "targets",
            "test %s: ffc %.4g in targets.%zu is a sigma_c of %.3g times the stress that consolidates it, and what is "
            "pressed alone does not get %.0f times as strong: correct it, or is it sigma_c/sigma_1?",
            test->name, of->value, of->entry, 1.0 / of->value, CEMENTED);
    }
}

void clod_plan_conflicts_unit(clod_loader *loader, const clod_plan *self, size_t test)
{
    const clod_plan_test *in = &self->tests[test];
    const clod_number *numbers = clod_test_kinds_of(in->middle)->numbers;
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *of = &self->targets[k];
        if (of->test != test) {
            continue;
        }
        if (numbers == CLOD_NUMBERS_UNIAXIAL) {
            check_cemented(loader, in, of);
        } else if (numbers == CLOD_NUMBERS_SHEAR && strcmp(of->number, "tau_p") == 0) {
            check_tau_p(loader, in, of, clod_case_shear(in->middle)->preshear_stress);
        } else if (numbers == CLOD_NUMBERS_SHEAR && strcmp(of->number, "tau") == 0) {
            check_shear_stress(loader, self, of, clod_case_shear(in->middle)->preshear_stress);
        }
    }
}
