// The procedure of the uniaxial test on fabricated states: what the walls feel is prescribed.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support/cell_state.h"
#include "tester/uniaxial.h"

// A mould of 80 mm: A = pi 0.08^2/4 = 5.026548e-3 m2.
#define AREA 5.026548245743669e-3
#define DT 1e-5
#define LID_START 0.06
#define TOP 0.05
#define STRESS 20e3
#define SPEED 0.01
#define GRAIN_MASS 0.4
#define WEIGHT (GRAIN_MASS * 9.81 / AREA) ///< Pa

enum { BASE, MOULD, LID };

typedef struct cell {
    clod_case from;
    clod_state state;
    clod_wall wall[3];
    clod_shape shape[3];
    cell_grains grains;
    clod_uniaxial test;
    double row[CLOD_UNIAXIAL_COLUMNS];
} cell;

static cell now;

/** Four grains of 0.1 kg and 3 mm, the highest with its top at 50 mm. */
static int make_cell(void **context)
{
    static const char *const NAMES[] = {"base", "mould", "lid"};
    (void)context;
    memset(&now, 0, sizeof now);
    now.from.uniaxial = (clod_case_uniaxial){.diameter = 0.08,
                                             .height = 0.05,
                                             .speed = SPEED,
                                             .crush_max = 0.1,
                                             .fill_max = 0.6,
                                             .settle_max = 0.3,
                                             .beyond_peak = 0.02};
    for (int w = 0; w < 3; w++) {
        snprintf(now.wall[w].name, sizeof now.wall[w].name, "%s", NAMES[w]);
        now.wall[w].shapes = &now.shape[w];
        now.wall[w].shape_count = 1;
        now.wall[w].load_axis = (clod_vec3){0.0, 0.0, -1.0};
    }
    now.shape[MOULD] = (clod_shape){.kind = CLOD_SHAPE_CYLINDER, .outer = 0.04};
    now.shape[LID] = (clod_shape){.kind = CLOD_SHAPE_ANNULUS, .center = {0.0, 0.0, LID_START}};
    now.wall[LID].load = CLOD_LOAD_STRESS;
    cell_state_make(&now.state, &now.grains, TOP - 0.003, GRAIN_MASS, now.wall, 3, DT);
    clod_uniaxial_begin(&now.test, &now.from, &now.state);
    return 0;
}

/** Advance by the planned steps under a stress at the lid, then look. */
static bool look(double stress)
{
    const int64_t steps = clod_uniaxial_plan(&now.test, &now.state);
    const double n = (double)steps;
    assert_true(steps > 0);
    for (int w = 0; w < 3; w++) {
        now.wall[w].sum_steps += steps;
        now.wall[w].shift.z += now.wall[w].velocity.z * n * DT;
    }
    now.wall[LID].sum_force.z += stress * AREA * n;
    now.wall[BASE].sum_force.z -= (0.9 * stress + WEIGHT) * AREA * n;
    now.wall[MOULD].sum_force.z -= 0.1 * stress * AREA * n;
    now.state.step += steps;
    return clod_uniaxial_sample(&now.test, &now.state, now.row);
}

/** Look until a phase is left; the number of looks, at most `most`. */
static int look_while(clod_uniaxial_phase phase, double stress, int most)
{
    int looks = 0;
    while (now.test.phase == phase && looks < most) {
        look(stress);
        looks++;
    }
    assert_int_not_equal(now.test.phase, phase);
    return looks;
}

static double height(void)
{
    return LID_START + now.wall[LID].shift.z;
}

static void go_to_consolidation(void)
{
    look_while(CLOD_UNIAXIAL_FILL, 0.0, 1000);
    clod_uniaxial_branch(&now.test, STRESS, &now.state);
    look_while(CLOD_UNIAXIAL_LOWER, 0.1 * STRESS, 1000);
    assert_int_equal(now.test.phase, CLOD_UNIAXIAL_CONSOLIDATE);
}

static void go_to_crushing(void)
{
    go_to_consolidation();
    look_while(CLOD_UNIAXIAL_CONSOLIDATE, STRESS, 1000);
    look_while(CLOD_UNIAXIAL_UNLOAD, 0.0, 10);
    look_while(CLOD_UNIAXIAL_FREE, 0.0, 1000);
    assert_int_equal(now.test.phase, CLOD_UNIAXIAL_CRUSH);
}

/** A smooth peak 1 mm below the unloaded height. */
static double peak_of(double stress)
{
    const double x = (now.test.unloaded_height - height() - 1e-3) / 1e-3;
    return stress / (1.0 + x * x);
}

static void filling_waits_for_rest_and_ends(void **context)
{
    (void)context;
    now.grains.motion[2][0] = 1.0; // rms of four: 0.5 m/s
    for (int k = 0; k < 100; k++) {
        assert_false(look(0.0));
    }
    now.grains.motion[2][0] = 0.0;
    assert_true(look(0.0));
    assert_int_equal(now.test.phase, CLOD_UNIAXIAL_DONE);
    assert_int_equal(now.test.flags, 0);
    assert_int_equal(clod_uniaxial_plan(&now.test, &now.state), 0);
    assert_true(clod_uniaxial_progress(&now.test) == 1.0);
    assert_true(now.state.adhesion == 0.1);
}

/** Nothing moves here, but what falls is that slow for twice 20 mm/s over g. */
static void where_gravity_is_weak_rest_takes_longer(void **context)
{
    (void)context;
    now.state.gravity[2] = -0.25; // 160 ms, in looks of 2 ms; 2 mm/s: 16 ms, as ever
    const int looks = look_while(CLOD_UNIAXIAL_FILL, 0.0, 1000);
    assert_true(looks == 80 || looks == 81);
    assert_int_equal(now.test.flags, 0);
    now.state.gravity[2] = -9.81;
    now.test.phase = CLOD_UNIAXIAL_FILL;
    go_to_crushing();
    now.state.gravity[2] = -0.05; // 80 ms
    now.test.phase = CLOD_UNIAXIAL_FREE;
    now.test.phase_start = (double)now.state.step * DT;
    const int free = look_while(CLOD_UNIAXIAL_FREE, 0.0, 1000);
    assert_true(free == 40 || free == 41);
}

static void filling_that_never_rests_is_told(void **context)
{
    (void)context;
    now.grains.motion[2][0] = 1.0;
    now.from.uniaxial.fill_max = 0.9; // the case says how long
    clod_uniaxial_begin(&now.test, &now.from, &now.state);
    look_while(CLOD_UNIAXIAL_FILL, 0.0, 100000);
    assert_int_equal(now.test.flags, CLOD_UNIAXIAL_NOT_SETTLED);
    assert_in_range(now.state.step, 90001, 90200); // a look is 200 steps
}

static void a_consolidation_begins_with_the_lid_at_the_grains(void **context)
{
    (void)context;
    look_while(CLOD_UNIAXIAL_FILL, 0.0, 1000);
    now.test.flags = CLOD_UNIAXIAL_NOT_SETTLED; // of the filling, not of this part
    clod_uniaxial_branch(&now.test, STRESS, &now.state);
    assert_int_equal(now.test.phase, CLOD_UNIAXIAL_LOWER);
    assert_int_equal(now.test.flags, 0);
    assert_true(fabs(height() - TOP) < 1e-15);
    assert_true(now.wall[LID].velocity.z < 0.0);
    assert_true(now.state.build_motion > 1.0); // the neighbour search starts anew
    look(0.04 * STRESS);
    assert_int_equal(now.test.phase, CLOD_UNIAXIAL_LOWER);
    assert_true(now.state.adhesion == 0.1);
    look(0.06 * STRESS);
    assert_int_equal(now.test.phase, CLOD_UNIAXIAL_CONSOLIDATE);
    assert_true(now.state.adhesion == 1.0);
    assert_int_equal(now.wall[LID].load, CLOD_LOAD_STRESS);
    assert_true(now.wall[LID].velocity.z == 0.0);
    assert_true(fabs(now.wall[LID].load_force / (0.06 * STRESS * AREA) - 1.0) < 1e-12);
}

static void consolidation_rests_under_its_stress(void **context)
{
    (void)context;
    go_to_consolidation();
    for (int k = 0; k < 12; k++) { // 2 ms each: the ramp is over after 20 ms
        look(0.1 * STRESS);
    }
    assert_int_equal(now.test.phase, CLOD_UNIAXIAL_CONSOLIDATE); // not at its stress yet
    assert_true(fabs(now.wall[LID].load_force / (STRESS * AREA) - 1.0) < 1e-12);
    const double at = height();
    for (int g = 0; g < CELL_GRAINS - 1; g++) {
        now.grains.place[g][2] = 0.02; // three of four, and whole, 9 mm and more from all walls
    }
    look_while(CLOD_UNIAXIAL_CONSOLIDATE, 0.99 * STRESS, 5);
    assert_int_equal(now.test.phase, CLOD_UNIAXIAL_UNLOAD);
    assert_int_equal(now.test.flags, 0);
    assert_int_equal(now.wall[LID].load, CLOD_LOAD_NONE);
    const clod_uniaxial *t = &now.test;
    assert_true(fabs(t->sigma_1 / (0.99 * STRESS) - 1.0) < 1e-12);
    assert_true(fabs(t->sigma_base / (0.9 * 0.99 * STRESS + WEIGHT) - 1.0) < 1e-12);
    assert_true(fabs(t->density / (GRAIN_MASS / (AREA * at)) - 1.0) < 1e-12);
    const double room = 3.141592653589793 * 0.031 * 0.031 * (at - 0.018);
    assert_true(fabs(t->inside / (0.75 * GRAIN_MASS / room) - 1.0) < 1e-12);
    // four spheres of 3 mm: 4 * 4/3 pi 27e-9 m3
    assert_true(fabs(t->solid_fraction / (4.523893421169302e-7 / (AREA * at)) - 1.0) < 1e-12);
    assert_true(fabs(now.row[CLOD_UNIAXIAL_MOULD_FORCE] / (0.099 * STRESS * AREA) - 1.0) <
                1e-12);
}

static void consolidation_that_never_rests_is_told(void **context)
{
    (void)context;
    go_to_consolidation();
    now.test.settle_max = 0.7;
    const int64_t before = now.state.step;
    look_while(CLOD_UNIAXIAL_CONSOLIDATE, 0.5 * STRESS, 100000);
    assert_int_equal(now.test.flags, CLOD_UNIAXIAL_NOT_SETTLED);
    assert_in_range(now.state.step - before, 70000, 70200); // a look is 200 steps
}

static void the_lid_goes_up_until_it_carries_nothing(void **context)
{
    (void)context;
    go_to_consolidation();
    now.wall[LID].servo_velocity = 1e-4; // what the servo had when it was switched off
    look_while(CLOD_UNIAXIAL_CONSOLIDATE, STRESS, 1000);
    assert_true(now.wall[LID].servo_velocity == 0.0);
    double before = 0.0;
    for (int k = 0; k < 30; k++) { // 50 steps of 10 us at 1 m/s2: 0.5 mm/s more each time
        look(0.5 * STRESS);
        const double speed = now.wall[LID].velocity.z;
        assert_true(fabs(speed - fmin(before + 5e-4, SPEED)) < 1e-15);
        before = speed;
    }
    assert_true(before == SPEED);
    look(-1.0);
    assert_int_equal(now.test.phase, CLOD_UNIAXIAL_FREE);
    assert_true(now.wall[LID].velocity.z == 0.0);
    assert_true(now.test.unloaded_height == height());
    assert_int_equal(now.state.changes.lost_walls, 1); // the step takes it away
    assert_string_equal(now.state.changes.lost_wall[0], "mould");
    clod_changes_fini(&now.state.changes);
}

static void the_free_specimen_comes_to_rest(void **context)
{
    (void)context;
    go_to_consolidation();
    look_while(CLOD_UNIAXIAL_CONSOLIDATE, STRESS, 1000);
    look_while(CLOD_UNIAXIAL_UNLOAD, 0.0, 10);
    // more than 20 ms: 10 looks of 2 ms by rounding of times, or one more
    assert_in_range(look_while(CLOD_UNIAXIAL_FREE, 0.0, 100), 10, 11);
    assert_int_equal(now.test.flags, 0);
}

static void grains_that_go_on_falling_are_told(void **context)
{
    (void)context;
    go_to_consolidation();
    look_while(CLOD_UNIAXIAL_CONSOLIDATE, STRESS, 1000);
    look_while(CLOD_UNIAXIAL_UNLOAD, 0.0, 10);
    now.grains.motion[1][2] = -0.1;
    look_while(CLOD_UNIAXIAL_FREE, 0.0, 100000);
    assert_int_equal(now.test.flags, CLOD_UNIAXIAL_NOT_FREE);
}

static void crushing_finds_the_peak(void **context)
{
    (void)context;
    go_to_crushing();
    const double zero = now.test.unloaded_height;
    assert_true(zero > 0.049 && zero < 0.05);
    for (int k = 0; k < 100000 && now.test.phase == CLOD_UNIAXIAL_CRUSH; k++) {
        look(peak_of(8e3));
        assert_true(now.wall[LID].velocity.z >= -SPEED);
    }
    assert_int_equal(now.test.phase, CLOD_UNIAXIAL_DONE);
    assert_int_equal(now.test.flags, 0);
    // smoothed over w = 0.2 % of 50 mm: lower by w^2/24 of the curvature 2 * 8 kPa/mm2, 0.08 %
    assert_true(fabs(now.test.strength / (8e3 * (1.0 - 8.3e-4)) - 1.0) < 1e-3);
    assert_true(fabs(now.test.peak_strain - 1e-3 / zero) < 2e-4);
    assert_true(fabs(now.test.strength_base - (0.9 * now.test.strength + WEIGHT)) < 1e-6);
    // 2 % beyond 2 %, and half a window
    assert_true(now.row[CLOD_UNIAXIAL_STRAIN] > 0.0400);
    assert_true(now.row[CLOD_UNIAXIAL_STRAIN] < 0.0425);
    assert_true(now.wall[LID].velocity.z == 0.0);
}

static void the_peak_is_looked_for_from_when_the_lid_meets_the_specimen(void **context)
{
    (void)context;
    go_to_crushing();
    for (int k = 0; k < 100000 && now.test.phase == CLOD_UNIAXIAL_CRUSH; k++) {
        // it sank by 2 mm, which is more than what is crushed beyond a peak
        const double sunk = now.test.unloaded_height - height() - 2e-3;
        look(sunk < 0.0 ? 0.0 : fmin(1e7 * sunk, 4e3 - 5e5 * sunk));
    }
    assert_int_equal(now.test.flags, 0);
    assert_true(now.test.strength > 3.5e3 && now.test.strength < 4e3);
}

static void stress_that_only_rises_is_told(void **context)
{
    (void)context;
    go_to_crushing();
    for (int k = 0; k < 100000 && now.test.phase == CLOD_UNIAXIAL_CRUSH; k++) {
        look(1e3 + 1e6 * (now.test.unloaded_height - height()));
    }
    assert_int_equal(now.test.flags, CLOD_UNIAXIAL_NO_PEAK);
    assert_true(now.row[CLOD_UNIAXIAL_STRAIN] > 0.1 && now.row[CLOD_UNIAXIAL_STRAIN] < 0.101);
    // the last 0.2 % before 10 % of strain
    assert_true(fabs(now.test.peak_strain - 0.099) < 5e-4);
}

static void a_specimen_that_falls_apart_has_no_strength(void **context)
{
    (void)context;
    go_to_crushing();
    look_while(CLOD_UNIAXIAL_CRUSH, 0.009 * STRESS, 100000);
    assert_int_equal(now.test.flags, CLOD_UNIAXIAL_COLLAPSED);
    assert_true(now.test.strength == 0.0);
}

static void a_lid_that_meets_no_grains_stops_the_test(void **context)
{
    (void)context;
    char text[256];
    look_while(CLOD_UNIAXIAL_FILL, 0.0, 1000);
    clod_uniaxial_branch(&now.test, STRESS, &now.state);
    assert_false(clod_uniaxial_trouble(&now.test, text, sizeof text));
    while (!look(0.0)) { // down to the diameter of a grain, 6 mm
        assert_true(height() >= 0.006);
    }
    assert_true(height() < 0.006);
    assert_true(clod_uniaxial_trouble(&now.test, text, sizeof text));
    assert_non_null(strstr(text, "too few grains"));
}

/** What was asked of the step, which is not here. */
static int end_cell(void **context)
{
    (void)context;
    clod_changes_fini(&now.state.changes);
    return 0;
}

int main(void)
{
#define T(name) cmocka_unit_test_setup_teardown(name, make_cell, end_cell)
    const struct CMUnitTest tests[] = {
        T(filling_waits_for_rest_and_ends),
        T(filling_that_never_rests_is_told),
        T(where_gravity_is_weak_rest_takes_longer),
        T(a_consolidation_begins_with_the_lid_at_the_grains),
        T(consolidation_rests_under_its_stress),
        T(consolidation_that_never_rests_is_told),
        T(the_lid_goes_up_until_it_carries_nothing),
        T(the_free_specimen_comes_to_rest),
        T(grains_that_go_on_falling_are_told),
        T(crushing_finds_the_peak),
        T(the_peak_is_looked_for_from_when_the_lid_meets_the_specimen),
        T(stress_that_only_rises_is_told),
        T(a_specimen_that_falls_apart_has_no_strength),
        T(a_lid_that_meets_no_grains_stops_the_test),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
