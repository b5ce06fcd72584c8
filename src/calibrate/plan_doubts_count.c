/**
 * @file plan_doubts_count.c
 * Fewer independent targets than parameters: a warning, before hours are spent.
 */

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/plural.h"
#include "calibrate/number.h"
#include "calibrate/plan_check.h"
#include "calibrate/test_kinds.h"

#define NAMES 8 ///< of a family, at most, and NULL

/** Numbers of which so many at most are independent. */
typedef struct family {
    const char *names[NAMES]; ///< none: all
    bool by_stress;           ///< two of them at one stress tell the same
    size_t most;
} family;

static const family LINE = {{"c", "phi_lin", "tau"}, false, 2};
static const family CIRCLES = {
    {"tau_p", "phi_sf", "phi_e", "sigma_1", "sigma_2", "sigma_c", "ffc"}, false, 3};
static const family WALL_LINE = {{"phi_w", "tau_ad", "phi_x"}, false, 2};
// One at each stress: over several stresses they lie on no line by definition.
static const family STRENGTH = {{"sigma_c", "ffc"}, true, SIZE_MAX};
static const family DENSITY = {{"rho_b", "rho_inside"}, true, SIZE_MAX};

static const family ANY = {{NULL}, false, SIZE_MAX};

#define SHEAR 3 ///< c, phi_lin and tau_p make all stresses and angles of one preshear

static bool is_of(const clod_plan_target *self, size_t test, const family *of)
{
    bool found = of->names[0] == NULL;
    for (size_t k = 0; k < NAMES && of->names[k] != NULL; k++) {
        found = found || strcmp(self->number, of->names[k]) == 0;
    }
    return found && self->test == test && !self->held_back;
}

static bool is_same(const clod_plan_target *a, const clod_plan_target *b, bool by_stress)
{
    return fabs(a->normal_stress - b->normal_stress) <=
               CLOD_NUMBER_SAME_STRESS * b->normal_stress &&
           (by_stress || strcmp(a->number, b->number) == 0);
}

/** Different used targets of a test that are of a family, as many as are independent. */
static size_t count_family(const clod_plan *self, size_t test, const family *of)
{
    size_t count = 0;
    for (size_t k = 0; k < self->target_count; k++) {
        bool new = is_of(&self->targets[k], test, of);
        for (size_t m = 0; m < k && new; m++) {
            new = !is_of(&self->targets[m], test, of) ||
                  !is_same(&self->targets[m], &self->targets[k], of->by_stress);
        }
        count += new ? 1 : 0;
    }
    return count < of->most ? count : of->most;
}

static size_t count_test(const clod_plan *self, size_t test)
{
    const clod_number *numbers = clod_test_kinds_of(self->tests[test].middle)->numbers;
    const size_t density = count_family(self, test, &DENSITY);
    if (numbers == CLOD_NUMBERS_SHEAR) {
        const size_t stresses =
            count_family(self, test, &LINE) + count_family(self, test, &CIRCLES);
        return (stresses < SHEAR ? stresses : SHEAR) + (density > 0 ? 1 : 0);
    }
    if (numbers == CLOD_NUMBERS_UNIAXIAL) {
        return count_family(self, test, &STRENGTH) + density;
    }
    return numbers == CLOD_NUMBERS_WALL ? count_family(self, test, &WALL_LINE) + density
                                        : count_family(self, test, &ANY);
}

void clod_plan_warn_count(clod_plan *self)
{
    size_t count = 0;
    for (size_t k = 0; k < self->test_count; k++) {
        count += count_test(self, k);
    }
    if (count < self->parameter_count) {
        clod_warning_list_add(
            &self->warnings,
            "parameters: %zu are free, and the used targets are %zu independent number%s at most (points of one line "
            "count as two): probably %zu combination%s of the parameters will stay unknown, whatever the budget. Free fewer of "
            "them, or give targets of another kind, stress or test",
            self->parameter_count, count, clod_plural((double)count),
            self->parameter_count - count,
            clod_plural((double)(self->parameter_count - count)));
    }
}
