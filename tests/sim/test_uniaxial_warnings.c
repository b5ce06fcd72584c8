// The warning box of the uniaxial test: each text with its remedy, from fabricated results.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "sim/uniaxial_warnings.h"
#include "tester/uniaxial.h"

#define PARTS 3 ///< the filling and two specimens

typedef struct box {
    clod_case from;
    clod_case_material ore;
    clod_part part[PARTS];
    clod_uniaxial test[PARTS];
} box;

static box now;

/** A filling, and two specimens that are as they should be: nothing to warn of. */
static int make_box(void **state)
{
    (void)state;
    memset(&now, 0, sizeof now);
    now.ore = (clod_case_material){.name = "ore", .density = 2500.0};
    now.from.materials = &now.ore;
    now.from.material_count = 1;
    now.from.uniaxial = (clod_case_uniaxial){.grain_material = "ore",
                                             .diameter = 0.08,
                                             .radius_mean = 1e-3,
                                             .fill_max = 0.5,
                                             .settle_max = 0.25};
    for (int p = 0; p < PARTS; p++) {
        const double stress = 10e3 * p;
        snprintf(now.part[p].name, sizeof now.part[p].name, p == 0 ? "fill" : "stress-%d", p);
        now.part[p].point = p - 1;
        now.part[p].test = &now.test[p];
        now.test[p] = (clod_uniaxial){.area = 5e-3,
                                      .stress = stress,
                                      .sigma_1 = stress,
                                      .sigma_base = stress,
                                      .strength = 0.5 * stress,
                                      .unloaded_height = 0.08,
                                      .speed = 1e-3};
    }
    return 0;
}

/** How many warnings there are, and how many of them hold all of the texts (NULL ends them). */
static void expect(size_t all, const char *const *texts)
{
    json_t *list = clod_uniaxial_warnings(&now.from, now.part, PARTS);
    size_t found = 0;
    for (size_t w = 0; w < json_array_size(list); w++) {
        const char *warning = json_string_value(json_array_get(list, w));
        bool holds = true;
        for (int t = 0; texts[t] != NULL; t++) {
            holds = holds && strstr(warning, texts[t]) != NULL;
        }
        found += holds ? 1 : 0;
    }
    assert_int_equal(json_array_size(list), all);
    assert_int_equal(found, all);
    json_decref(list);
}
#define EXPECT(all, ...) expect(all, (const char *const[]){__VA_ARGS__, NULL})

static void nothing_is_wrong(void **state)
{
    (void)state;
    EXPECT(0, "");
}

static void a_limit_of_time_is_named(void **state)
{
    (void)state;
    now.test[0].flags = CLOD_UNIAXIAL_NOT_SETTLED;
    EXPECT(1, "fill: filling", "uniaxial.fill_max (0.5 s): raise it");
    make_box(state);
    now.test[2].flags = CLOD_UNIAXIAL_NOT_SETTLED;
    EXPECT(1, "stress-2: consolidation", "uniaxial.settle_max (0.25 s): raise it",
           "lid_damping");
    make_box(state);
    now.test[1].flags = CLOD_UNIAXIAL_NOT_FREE;
    EXPECT(1, "stress-1: grains still moved", "0.25 s after", "raise uniaxial.settle_max");
}

static void a_stress_that_was_not_reached_has_its_reason(void **state)
{
    (void)state;
    now.test[1].sigma_1 = now.test[1].sigma_base = 9.06e3; // of 10
    EXPECT(1, "stress-1: the consolidation stress was 9.06 kPa instead of 10 kPa",
           "still gave way or the lid swung", "raise uniaxial.settle_max");
}

static void a_specimen_that_falls_apart_has_a_remedy(void **state)
{
    (void)state;
    now.test[1].flags = CLOD_UNIAXIAL_COLLAPSED;
    now.test[1].strength = 0.0;
    EXPECT(1, "stress-1: the specimen did not stand", "raise its adhesion (k_adh)",
           "uniaxial.height");
}

// 80 mm over grains of 16 mm: 5.
static void a_mould_that_is_too_narrow_has_a_remedy(void **state)
{
    (void)state;
    now.from.uniaxial.radius_mean = 8e-3;
    now.test[1].speed = now.test[2].speed = 0.0; // inertia is another warning
    EXPECT(1, "only 5.0 grain diameters across the specimen; 10 are wanted",
           "Use a larger mould or smaller grains");
}

// In whichever order the stresses stand in the case.
static void a_strength_that_falls_is_told(void **state)
{
    (void)state;
    now.test[1].strength = 6e3;
    now.test[2].strength = 5e3;
    const char *const words[] = {"sigma_c falls from 6.000 to 5.000 kPa",
                                 "from 10.000 to 20.000 kPa", "other specimens", NULL};
    expect(1, words);
    const clod_uniaxial first = now.test[1];
    now.test[1] = now.test[2];
    now.test[2] = first;
    expect(1, words);
    now.test[1].strength = 6e3; // as much is no fall
    EXPECT(0, "");
}

int main(void)
{
#define T(name) cmocka_unit_test_setup(name, make_box)
    const struct CMUnitTest tests[] = {
        T(nothing_is_wrong),
        T(a_limit_of_time_is_named),
        T(a_stress_that_was_not_reached_has_its_reason),
        T(a_specimen_that_falls_apart_has_a_remedy),
        T(a_mould_that_is_too_narrow_has_a_remedy),
        T(a_strength_that_falls_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
