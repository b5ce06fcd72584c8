#include "calibrate/test_kinds.h"

#include <math.h>

#include "calibrate/plan_targets.h"

// ---- packings

static int64_t seeds_one(const clod_case *from)
{
    (void)from;
    return 1;
}

static int64_t seeds_shear(const clod_case *from)
{
    return clod_case_shear(from)->seeds;
}

static int64_t seeds_wall(const clod_case *from)
{
    return from->wall_friction.seeds;
}

// ---- normal stresses

static bool is_among(double stress, const double *stresses, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        if (fabs(stresses[k] / stress - 1.0) < CLOD_NUMBER_SAME_STRESS) {
            return true;
        }
    }
    return false;
}

/** Whether the simulated points reach to both sides of a normal stress. */
static bool has_stress_shear(const clod_case *from, double stress)
{
    const clod_case_programme *shear = clod_case_shear(from);
    double least = HUGE_VAL, most = 0.0;
    for (size_t k = 0; k < shear->shear_stress_count; k++) {
        least = fmin(least, shear->shear_stresses[k]);
        most = fmax(most, shear->shear_stresses[k]);
    }
    return stress >= (1.0 - CLOD_NUMBER_SAME_STRESS) * least &&
           stress <= (1.0 + CLOD_NUMBER_SAME_STRESS) * most;
}

static bool has_stress_uniaxial(const clod_case *from, double stress)
{
    return is_among(stress, from->uniaxial.consolidation_stresses,
                    from->uniaxial.consolidation_stress_count);
}

static bool has_stress_wall(const clod_case *from, double stress)
{
    return is_among(stress, from->wall_friction.wall_stresses,
                    from->wall_friction.wall_stress_count);
}

// ---- rows

#define SHEAR                                                                                  \
    {                                                                                          \
        .name = "ring shear or Jenike test", .numbers = CLOD_NUMBERS_SHEAR,                    \
        .number_count = CLOD_NUMBERS_SHEAR_COUNT, .seeds = seeds_shear,                        \
        .has_stress = has_stress_shear, .without_stress = "outside the shear_stresses",        \
        .read = clod_number_read_shear, .tables = {                                            \
            &CLOD_PLAN_TABLE_SHEAR,                                                            \
            &CLOD_PLAN_TABLE_DENSITY,                                                          \
            &CLOD_PLAN_TABLE_FLOW                                                              \
        }                                                                                      \
    }

static const clod_test_kind ROWS[CLOD_CASE_KINDS] = {
    [CLOD_CASE_FREE] = {.name = "free run",
                        .numbers = CLOD_NUMBERS_PATH,
                        .number_count = CLOD_NUMBERS_PATH_COUNT,
                        .paths = true,
                        .seeds = seeds_one,
                        .read = clod_number_read_summary,
                        .tables = {&CLOD_PLAN_TABLE_REPOSE}},
    [CLOD_CASE_RING_SHEAR] = SHEAR,
    [CLOD_CASE_JENIKE] = SHEAR,
    [CLOD_CASE_UNIAXIAL] = {.name = "uniaxial test",
                            .numbers = CLOD_NUMBERS_UNIAXIAL,
                            .number_count = CLOD_NUMBERS_UNIAXIAL_COUNT,
                            .seeds = seeds_one,
                            .has_stress = has_stress_uniaxial,
                            .without_stress = "not among the consolidation_stresses",
                            .read = clod_number_read_summary,
                            .tables = {&CLOD_PLAN_TABLE_DENSITY, &CLOD_PLAN_TABLE_FLOW}},
    [CLOD_CASE_WALL_FRICTION] = {.name = "wall friction test",
                                 .numbers = CLOD_NUMBERS_WALL,
                                 .number_count = CLOD_NUMBERS_WALL_COUNT,
                                 .seeds = seeds_wall,
                                 .has_stress = has_stress_wall,
                                 .without_stress = "not among the wall_stresses",
                                 .read = clod_number_read_summary,
                                 .tables = {&CLOD_PLAN_TABLE_WALL}},
    [CLOD_CASE_CONTACT_BENCH] = {.seeds = seeds_one}, // no test: it has no grains
};

const clod_test_kind *clod_test_kinds_row(clod_case_kind kind)
{
    return &ROWS[kind];
}

const clod_test_kind *clod_test_kinds_of(const clod_case *from)
{
    return clod_test_kinds_row(clod_case_kind_of(from));
}
