/**
 * @file number_summary.c
 * Numbers of a uniaxial or a wall friction test: of its summary; and all numbers that are read there.
 */

#include <math.h>

#include "base/json.h"
#include "calibrate/number.h"

/** A number of the row with the target's stress, in a list of rows. The stress is the one that was asked
 *  for, as in the plan: what reaches the grains depends on the packing. */
static double of_rows(const json_t *rows, const char *stress_key, const char *key,
                      const clod_plan_target *target)
{
    size_t index;
    const json_t *row;
    json_array_foreach(rows, index, row)
    {
        const double stress = json_number_value(json_object_get(row, stress_key));
        const json_t *found = json_object_get(row, key);
        if (fabs(stress / target->normal_stress - 1.0) < CLOD_NUMBER_SAME_STRESS &&
            json_is_number(found)) {
            return json_number_value(found);
        }
    }
    return (double)NAN;
}

// ---- uniaxial tests

static double of_consolidation(const json_t *summary, const char *key,
                               const clod_plan_target *target)
{
    return of_rows(json_object_get(summary, "flow_function"), "consolidation_stress_Pa", key,
                   target);
}

static double of_flow_function(const json_t *summary, const clod_number *self,
                               const clod_plan_target *target)
{
    return clod_number_moved(target, of_consolidation(summary, self->field, target),
                             of_consolidation(summary, "sigma_1_Pa", target));
}

const clod_number CLOD_NUMBERS_UNIAXIAL[CLOD_NUMBERS_UNIAXIAL_COUNT] = {
    {"sigma_c", CLOD_NUMBER_STRESS, true, "sigma_c_Pa", of_flow_function},
    {"ffc", CLOD_NUMBER_RATIO, true, "ffc", of_flow_function},
    {"rho_b", CLOD_NUMBER_DENSITY, true, "bulk_density_kg_m3", of_flow_function},
    {"rho_inside", CLOD_NUMBER_DENSITY, true, "inside_density_kg_m3", of_flow_function},
};

// ---- wall friction tests

/** A number of the wall yield locus's line. */
static double of_line(const json_t *summary, const clod_number *self)
{
    const json_t *locus = json_object_get(summary, "wall_locus");
    const json_t *found = json_object_get(json_object_get(locus, self->field), "value");
    return json_is_number(found) ? json_number_value(found) : (double)NAN;
}

static double of_line_stress(const json_t *summary, const clod_number *self,
                             const clod_plan_target *target)
{
    (void)target;
    return of_line(summary, self);
}

static double of_line_angle(const json_t *summary, const clod_number *self,
                            const clod_plan_target *target)
{
    (void)target;
    return CLOD_NUMBER_DEGREE * of_line(summary, self);
}

static double of_point_angle(const json_t *summary, const clod_number *self,
                             const clod_plan_target *target)
{
    const json_t *locus = json_object_get(summary, "wall_locus");
    return CLOD_NUMBER_DEGREE *
           of_rows(json_object_get(locus, "points"), "wall_stress_Pa", self->field, target);
}

static double of_parts(const json_t *summary, const clod_number *self,
                       const clod_plan_target *target)
{
    double value = (double)NAN;
    size_t index;
    const json_t *part; // the filling has no stresses
    json_array_foreach(json_object_get(summary, "parts"), index, part)
    {
        value = fmax(value, of_rows(json_object_get(part, "stresses"), "wall_stress_Pa",
                                    self->field, target));
    }
    return value;
}

const clod_number CLOD_NUMBERS_WALL[CLOD_NUMBERS_WALL_COUNT] = {
    {"phi_x", CLOD_NUMBER_ANGLE, true, "phi_x_deg", of_point_angle},
    {"phi_w", CLOD_NUMBER_SLOPE, false, "phi_w_deg", of_line_angle},
    {"tau_ad", CLOD_NUMBER_LINE, false, "tau_ad_Pa", of_line_stress},
    {"rho_b", CLOD_NUMBER_DENSITY, true, "bulk_density_kg_m3", of_parts},
};

// ---- all of them

bool clod_number_read_summary(const clod_plan *plan, size_t test, const char *folder,
                              double *values, double *stresses, clod_status *status)
{
    json_t *summary = clod_json_read(folder, "summary.json", status);
    for (size_t t = 0; t < plan->target_count && summary != NULL; t++) {
        const clod_plan_target *target = &plan->targets[t];
        if (target->test != test) {
            continue;
        }
        const clod_number *kind = clod_number_find(&plan->tests[test], target->number);
        values[t] = kind->of != NULL ? kind->of(summary, kind, target)
                                     : clod_number_path_read(summary, kind, target);
        if (stresses != NULL && target->curve != NULL) { // of uniaxial tests alone
            stresses[t] = of_consolidation(summary, "sigma_1_Pa", target);
        }
    }
    const bool good = summary != NULL;
    json_decref(summary);
    return good;
}
