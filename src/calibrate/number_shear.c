/**
 * @file number_shear.c
 * Numbers of a shear test: of the yield locus of its points.
 */

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/fields.h"
#include "analysis/study_file.h"
#include "calibrate/number.h"
#include "clod/locus.h"

const clod_number CLOD_NUMBERS_SHEAR[CLOD_NUMBERS_SHEAR_COUNT] = {
    {"phi_lin", CLOD_NUMBER_SLOPE, false, NULL, NULL},
    {"phi_e", CLOD_NUMBER_ANGLE, false, NULL, NULL},
    {"phi_sf", CLOD_NUMBER_SLOPE, false, NULL, NULL},
    {"c", CLOD_NUMBER_LINE, false, NULL, NULL},
    {"tau_p", CLOD_NUMBER_STRESS, false, NULL, NULL},
    {"tau", CLOD_NUMBER_LINE, true, NULL, NULL}, // on the line, at its normal stress
    {"sigma_1", CLOD_NUMBER_STRESS, false, NULL, NULL},
    {"sigma_2", "Pa", {"kPa", 1e-3, 2}, -1e8, 1e8, false, false, NULL, NULL}, // tension below 0
    {"sigma_c", CLOD_NUMBER_STRESS, false, NULL, NULL},
    {"ffc", CLOD_NUMBER_RATIO, false, NULL, NULL},
    {"rho_b", CLOD_NUMBER_DENSITY, false, NULL, NULL},
    {"rho_inside", CLOD_NUMBER_DENSITY, false, NULL, NULL},
};

static double of_locus(const clod_locus *locus, const clod_plan_target *target)
{
    if (strcmp(target->number, "tau") == 0) {
        return locus->c.value + target->normal_stress * tan(locus->phi_lin.value);
    }
    double value = (double)NAN;
    for (clod_field_index k = 0; k < CLOD_FIELD_COUNT; k++) {
        if (strcmp(CLOD_FIELDS[k].key, target->number) == 0) {
            value = clod_field_get(locus, k).value;
        }
    }
    return clod_number_moved(target, value, locus->sigma_1.value);
}

bool clod_number_read_shear(const clod_plan *plan, size_t test, const char *folder,
                            double *values, double *stresses, clod_status *status)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/points.csv", folder);
    clod_locus_study *study = clod_study_of_run(path, status);
    if (study == NULL) {
        return false;
    }
    for (size_t t = 0; t < plan->target_count; t++) {
        if (plan->targets[t].test != test) {
            continue;
        }
        const clod_locus *locus = &study->groups[0].locus;
        values[t] = of_locus(locus, &plan->targets[t]);
        if (stresses != NULL && plan->targets[t].curve != NULL) {
            stresses[t] = locus->sigma_1.value;
        }
    }
    clod_locus_study_destroy(&study);
    return true;
}
