// The warning box of the wall friction test: each text with its remedy, from fabricated results.

#include "sim/wall_shear_warnings.h"

#include <stdio.h>
#include <string.h>

#include "support/check.h"
#include "tester/wall_shear.h"

typedef struct box {
    clod_case from;
    clod_case_material ore[2];
    clod_case_contact pairs[4];
    clod_part part[2];
    clod_wall_shear test[2];
} box;

static box now;

/** A filling, and a shear that is as it should be: nothing to warn of. */
static int make_box(void **state)
{
    (void)state;
    memset(&now, 0, sizeof now);
    now.ore[0] = (clod_case_material){.name = "ore", .density = 2500.0};
    now.ore[1] = (clod_case_material){.name = "plate"};
    now.from.materials = now.ore;
    now.from.material_count = 2;
    now.from.pairs = now.pairs;
    now.pairs[0].friction = 0.5;
    now.pairs[1].friction = now.pairs[2].friction = 0.6;
    now.from.wall_friction = (clod_case_wall_friction){.grain_material = "ore",
                                                       .plate_material = "plate",
                                                       .seeds = 1,
                                                       .radius_mean = 1e-3,
                                                       .speed = 1e-3,
                                                       .shear_max = 0.02,
                                                       .fill_max = 0.5,
                                                       .settle_max = 0.25};
    for (int p = 0; p < 2; p++) {
        snprintf(now.part[p].name, sizeof now.part[p].name, p == 0 ? "fill" : "wall");
        now.part[p].point = p - 1;
        now.part[p].test = &now.test[p];
    }
    now.test[1].at = 2;
    for (int k = 0; k < 2; k++) {
        const double stress = k == 0 ? 20e3 : 10e3;
        now.test[1].stresses[k] = stress;
        now.test[1].point[k] = (clod_wall_shear_point){
            .normal = stress, .shear = 0.3 * stress, .height = 0.02, .steady = 1};
    }
    return 0;
}

/** The only warning holds all of the texts (NULL ends them); none when there are none. */
static void expect(const char *const *texts)
{
    json_t *list = clod_wall_shear_warnings(&now.from, now.part, 2);
    assert_int_equal(json_array_size(list), texts[0] != NULL ? 1 : 0);
    for (int t = 0; texts[t] != NULL; t++) {
        const char *warning = json_string_value(json_array_get(list, 0));
        if (strstr(warning, texts[t]) == NULL) {
            fail_msg("\"%s\" is not in \"%s\"", texts[t], warning);
        }
    }
    json_decref(list);
}
#define EXPECT(...) expect((const char *const[]){__VA_ARGS__, NULL})

static void nothing_is_wrong(void **state)
{
    (void)state;
    EXPECT(NULL);
}

static void a_limit_of_time_is_named(void **state)
{
    (void)state;
    now.test[0].flags = CLOD_WALL_SHEAR_NOT_SETTLED;
    EXPECT("fill: filling", "wall_friction.fill_max (0.5 s): raise it");
    make_box(state);
    now.test[1].flags = CLOD_WALL_SHEAR_NOT_SETTLED;
    EXPECT("wall: consolidation", "wall_friction.settle_max (0.25 s)", "lid_damping");
}

static void a_stress_that_was_not_steady_has_its_rate(void **state)
{
    (void)state;
    now.test[1].point[1].steady = 0;
    now.test[1].point[1].displacement = 19.5e-3;
    now.test[1].point[1].rate = 40e3; // Pa/m: 0.04 kPa/mm
    now.test[1].point[1].rate_error = 10e3;
    EXPECT("wall: at 10 kPa", "not steady after 19.5 mm", "shear_max = 20 mm",
           "3 kPa, changing by 0.04 ± 0.01 kPa per mm");
}

/** 18.8 of 20 kPa: 6 % are missing. */
static void sides_that_carry_are_told(void **state)
{
    (void)state;
    now.test[1].point[0].normal = 18.8e3;
    EXPECT("wall: of 20 kPa, 18.8 kPa came to the plate", "side material");
    now.test[1].point[0].normal = 19.2e3; // 4 %
    EXPECT(NULL);
    now.test[1].point[1].normal = 10.6e3; // more than asked: no side carries it
    EXPECT("wall: 10 kPa were asked for, and the plate has 10.6 kPa", "weight",
           "wall_friction.grain_count");
}

/** A ring, one specimen, a plate smoother than the grains: in any other test the error bars have it
 *  or it is not there. */
static void a_lever_that_no_error_shows_is_told(void **state)
{
    (void)state;
    now.pairs[1].friction = now.pairs[2].friction = 0.25;
    EXPECT("the plate (friction 0.25) is smoother than the grains (0.5)", "cell: straight");
    now.from.wall_friction.seeds = 2;
    EXPECT(NULL);
    now.from.wall_friction.seeds = 1;
    now.from.wall_friction.cell = CLOD_CASE_CELL_STRAIGHT;
    EXPECT(NULL);
    now.from.wall_friction.cell = CLOD_CASE_CELL_RING;
    now.from.wall_friction.plate_ridges.height = 1e-3; // no smooth plate
    EXPECT(NULL);
    now.from.wall_friction.plate_ridges.height = 0.0;
    now.test[1].at = 0; // nothing was sheared
    EXPECT(NULL);
}

/** Flanks of 45 deg: a grain of 2 mm sinks 1 mm + 1 mm (1 - sqrt 2) = 0.586 mm, 0.29 diameters; flanks
 *  of tan a = 0.4: 0.4 mm + 1 mm (1 - sqrt 1.16) = 0.323 mm, 0.16. */
static void high_ridges_in_a_straight_cell_are_told(void **state)
{
    (void)state;
    clod_case_wall_friction *test = &now.from.wall_friction;
    now.pairs[1].friction = now.pairs[2].friction = 0.2;
    test->cell = CLOD_CASE_CELL_STRAIGHT;
    test->outer_radius = 0.01;
    test->plate_ridges = (clod_case_ridges){.height = 1e-3, .spacing = 2e-3};
    EXPECT("grains sink 0.29 of their diameter", "Use cell: ring");
    test->cell = CLOD_CASE_CELL_RING;
    EXPECT(NULL);
    test->cell = CLOD_CASE_CELL_STRAIGHT;
    test->plate_ridges.height = 0.4e-3;
    EXPECT(NULL);
    test->plate_ridges.width = 0.5e-3; // a floor wide enough for the grain to lie on: 0.4 mm
    EXPECT("grains sink 0.2 of their diameter", "at most 0.18");
}

/** A plate that grips as its grains do is held to them by the side wall of a straight cell; a ring lets the solid shear.
 *  Ridges that grains hardly sink between make it no smoother. */
static void a_plate_no_smoother_than_the_grains_in_a_straight_cell_is_told(void **state)
{
    (void)state;
    clod_case_wall_friction *test = &now.from.wall_friction;
    test->cell = CLOD_CASE_CELL_STRAIGHT;
    test->outer_radius = 0.01;
    EXPECT("the plate (friction 0.6) is not smoother than the grains (0.5)", "Use cell: ring");
    test->plate_ridges = (clod_case_ridges){.height = 0.1e-3, .spacing = 2e-3};
    EXPECT("the plate (friction 0.6) is not smoother than the grains (0.5)", "Use cell: ring");
    test->plate_ridges.height = 1e-3; // said once, by the ridges
    EXPECT("grains sink 0.29 of their diameter", "Use cell: ring");
    test->plate_ridges.height = 0.0;
    now.pairs[1].friction = now.pairs[2].friction = 0.5;
    EXPECT("the plate (friction 0.5) is not smoother than the grains (0.5)");
    now.pairs[1].friction = now.pairs[2].friction = 0.49;
    EXPECT(NULL);
    now.pairs[1].friction = now.pairs[2].friction = 0.6;
    test->cell = CLOD_CASE_CELL_RING;
    EXPECT(NULL);
    test->cell = CLOD_CASE_CELL_STRAIGHT;
    now.test[1].at = 0; // nothing was sheared
    EXPECT(NULL);
}

/** I = 0.01/0.02 1/s 2 mm sqrt(2500/20e3) = 3.5e-4 at 10 mm/s, and 3.5e-3 at 100 mm/s. */
static void what_is_too_fast_is_told(void **state)
{
    (void)state;
    now.from.wall_friction.speed = 0.01;
    EXPECT(NULL);
    now.from.wall_friction.speed = 0.1;
    EXPECT("wall: inertial number 0.0035", "lower wall_friction.speed");
}

/** 20 mm less 17: 1.5 grains of 2 mm. */
static void bars_near_the_plate_are_told(void **state)
{
    (void)state;
    now.test[1].bar_height = 0.015;
    EXPECT(NULL);
    now.test[1].bar_height = 0.017;
    EXPECT("wall: only 1.5 grain diameters between the bars", "Raise wall_friction.depth");
    now.test[1].bar_height = 0.015; // and 2 mm of ridges below
    now.from.wall_friction.plate_ridges.height = 2e-3;
    EXPECT("wall: only 1.5 grain diameters between the bars", "Raise wall_friction.depth");
}

static void soft_grains_are_told(void **state)
{
    (void)state;
    now.part[1].max_overlap = 0.06;
    EXPECT("wall: overlap up to 6.0 % of a radius");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(nothing_is_wrong, make_box),
        cmocka_unit_test_setup(a_limit_of_time_is_named, make_box),
        cmocka_unit_test_setup(a_stress_that_was_not_steady_has_its_rate, make_box),
        cmocka_unit_test_setup(sides_that_carry_are_told, make_box),
        cmocka_unit_test_setup(a_lever_that_no_error_shows_is_told, make_box),
        cmocka_unit_test_setup(high_ridges_in_a_straight_cell_are_told, make_box),
        cmocka_unit_test_setup(a_plate_no_smoother_than_the_grains_in_a_straight_cell_is_told,
                               make_box),
        cmocka_unit_test_setup(what_is_too_fast_is_told, make_box),
        cmocka_unit_test_setup(bars_near_the_plate_are_told, make_box),
        cmocka_unit_test_setup(soft_grains_are_told, make_box),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
