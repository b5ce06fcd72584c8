// The procedure of the ring shear test on fabricated states: what the walls feel is prescribed.
#include "support/ring_states.h"

static void geometry_is_that_of_the_cell(void **context)
{
    (void)context;
    assert_true(fabs(now.test.area / AREA - 1.0) < 1e-14);
    assert_true(fabs(now.test.mean_radius / MEAN_RADIUS - 1.0) < 1e-14);
    // 8 * 0.02 * 0.001 * 0.003
    assert_true(fabs(now.test.bars_volume / 4.8e-7 - 1.0) < 1e-14);
    assert_true(now.test.grain_mass == GRAIN_MASS);
}

static void filling_waits_for_rest(void **context)
{
    (void)context;
    now.grains.motion[2][0] = 1.0; // rms of four: 0.5 m/s
    for (int k = 0; k < 100; k++) {
        look(0.0, 0.0);
    }
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_FILL);
    now.grains.motion[2][0] = 0.0;
    look(0.0, 0.0);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_LOWER);
    assert_int_equal(now.test.flags, 0);
    // bars' tips at the top of the grains, 0.036 + 0.003 m: the plane at 0.045 m
    assert_true(fabs(LID_START + now.wall[2].shift.z - 0.045) < 1e-12);
    assert_true(now.wall[2].velocity.z < 0.0);
    assert_true(now.state.build_motion > 1.0); // the neighbour search starts anew
}

static void filling_that_never_rests_is_told(void **context)
{
    (void)context;
    now.grains.motion[2][0] = 1.0;
    now.from.ring_shear.fill_max = 0.9; // the case says how long
    clod_ring_shear_begin(&now.test, &now.from, &now.state);
    look_while(CLOD_RING_SHEAR_FILL, 0.0, 0.0, 100000);
    assert_int_equal(now.test.flags, CLOD_RING_SHEAR_NOT_SETTLED);
    assert_true(fabs((double)now.state.step * now.state.dt - 0.9) < 201.0 * now.state.dt);
}

static void lid_carries_then_the_load_is_raised(void **context)
{
    (void)context;
    look_while(CLOD_RING_SHEAR_FILL, 0.0, 0.0, 1000);
    assert_int_equal(now.wall[2].load, CLOD_LOAD_NONE);
    look(0.0, 0.0);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_LOWER);
    assert_true(now.state.adhesion == 0.1);
    look(0.1 * PRESHEAR, 0.0);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_CONSOLIDATE);
    assert_int_equal(now.wall[2].load, CLOD_LOAD_STRESS);
    assert_true(now.state.adhesion == 1.0);
    assert_true(now.wall[2].velocity.z == 0.0);
    // the servo takes over with the stress that the lid was put down with: no look unloaded
    assert_true(fabs(now.wall[2].load_force - 0.1 * PRESHEAR * AREA) < 1e-9);
    double before = now.wall[2].load_force;
    for (int k = 0; k < 12; k++) { // 2 ms each: the ramp is over after 20 ms
        look(0.1 * PRESHEAR, 0.0);
        assert_true(now.wall[2].load_force >= before);
        before = now.wall[2].load_force;
    }
    // at the shear plane: less what the solid above it weighs, and the lid's tips are at
    // 0.036 m or less by now, so that is one grain at 0.036 m or none
    const double solid =
        now.grains.place[3][2] > LID_START + now.wall[2].shift.z - BAR_HEIGHT ? 0.5 : 0.0;
    assert_true(fabs(before - (PRESHEAR * AREA - solid * 9.81)) < 1e-9 * PRESHEAR);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_CONSOLIDATE); // not at its stress yet
}

static void stresses_are_forces_and_torques_over_the_area(void **context)
{
    (void)context;
    go_to_preshear();
    now.grains.place[3][2] = 0.2; // 0.5 kg above the plane
    look(9e3, 6e3);
    const double *row = now.row;
    assert_true(fabs(row[CLOD_RING_SHEAR_NORMAL_STRESS] / (9e3 + 0.5 * 9.81 / AREA) - 1) <
                1e-12);
    assert_true(fabs(row[CLOD_RING_SHEAR_NORMAL_STRESS_BASE] / (9e3 + 2.0 * 9.81 / AREA) - 1) <
                1e-12);
    assert_true(fabs(row[CLOD_RING_SHEAR_SHEAR_STRESS] / 6e3 - 1) < 1e-12);
    assert_true(fabs(row[CLOD_RING_SHEAR_SHEAR_STRESS_BASE] / 6e3 - 1) < 1e-12);
    const double height = LID_START + now.wall[2].shift.z;
    assert_true(fabs(row[CLOD_RING_SHEAR_HEIGHT] / height - 1) < 1e-14);
    assert_true(fabs(row[CLOD_RING_SHEAR_BULK_DENSITY] / (2.0 / (AREA * height - 4.8e-7)) - 1) <
                1e-12);
    assert_true(row[CLOD_RING_SHEAR_PHASE] == CLOD_RING_SHEAR_PRESHEAR);
    // the load makes up for the solid above
    assert_true(fabs(now.wall[2].load_force - (PRESHEAR * AREA - 0.5 * 9.81)) < 1e-9);
}

static void sums_begin_anew_after_every_look(void **context)
{
    (void)context;
    go_to_preshear();
    look(PRESHEAR, 6e3);
    look(PRESHEAR, 1e3);
    assert_true(fabs(now.row[CLOD_RING_SHEAR_SHEAR_STRESS] / 1e3 - 1) < 1e-12);
    assert_int_equal(now.wall[0].sum_steps, 0);
}

static void speed_rises_without_a_blow(void **context)
{
    (void)context;
    go_to_preshear();
    double before = now.wall[0].spin * MEAN_RADIUS;
    assert_true(before <= 3.0 * 200 * DT * (1.0 + 1e-12)); // in the look that began preshear
    double travelled = 0.0;
    while (before < SPEED) {
        const double time = (double)now.state.step * DT;
        look(PRESHEAR, 6e3);
        const double interval = (double)now.state.step * DT - time;
        travelled += before * interval;
        const double speed = now.wall[0].spin * MEAN_RADIUS;
        assert_true(now.wall[1].spin == now.wall[0].spin); // sides turn with the trough
        assert_true(speed > before && speed - before <= 3.0 * interval * (1.0 + 1e-12));
        before = speed;
    }
    assert_true(fabs(before - SPEED) < 1e-15);
    assert_true(fabs(now.test.displacement - travelled) < 1e-12);
}

static void reversal_ends_without_shear_stress(void **context)
{
    (void)context;
    go_to_the_end_of_preshear();
    now.test.flags = CLOD_RING_SHEAR_NOT_STEADY; // of the preparation, not of the reversal
    clod_ring_shear_reverse(&now.test, &now.state);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_REVERSE);
    for (int k = 0; k < 300; k++) { // from 30 mm/s to -1 mm/s at 3 m/s2 takes 10.3 ms
        look(PRESHEAR, 3e3);
    }
    assert_true(fabs(now.wall[0].spin * MEAN_RADIUS + 0.033 * SPEED) < 1e-12);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_REVERSE);
    look(PRESHEAR, -1.0);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_DONE);
    assert_int_equal(now.test.flags, 0);
    assert_int_equal(clod_ring_shear_plan(&now.test, &now.state), 0);
}

static void point_reduces_and_shears_to_the_peak(void **context)
{
    (void)context;
    go_to_the_end_of_reversal();
    clod_ring_shear_branch(&now.test, 4e3, &now.state);
    while (now.wall[0].spin > 0.0) { // braked at 3 m/s2 while the load is on its ramp
        assert_int_equal(now.test.phase, CLOD_RING_SHEAR_REDUCE);
        look(7e3, 0.0);
    }
    assert_true(now.wall[0].spin == 0.0 && now.wall[1].spin == 0.0); // at rest meanwhile
    look_while(CLOD_RING_SHEAR_REDUCE, 4e3, 0.0, 1000);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_SHEAR);
    assert_true(fabs(now.wall[2].load_force - 4e3 * AREA) < 6.0); // less 0.5 kg at most
    // a smooth peak of 3.5 kPa at 1 mm
    for (int k = 0; k < 100000 && now.test.phase == CLOD_RING_SHEAR_SHEAR; k++) {
        const double x = (now.test.displacement - 1e-3) / 1e-3;
        look(4e3, 3.5e3 / (1.0 + x * x));
    }
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_DONE);
    assert_int_equal(now.test.flags, 0);
    // smoothed over 0.2 mm: lower by 0.2^2/24 of the curvature 2 * 3.5 kPa/mm2, 0.33 %
    assert_true(fabs(now.test.point_shear / (3.5e3 * (1.0 - 0.0033)) - 1.0) < 1e-3);
    assert_true(fabs(now.test.point_displacement - 1e-3) < 2e-5);
    assert_true(now.row[CLOD_RING_SHEAR_DISPLACEMENT] > 2e-3 &&
                now.row[CLOD_RING_SHEAR_DISPLACEMENT] < 2.2e-3);
    // speed with the square root of the stress
    assert_true(fabs(now.test.shear_speed / (SPEED * sqrt(0.4)) - 1.0) < 1e-12);
}

static void the_normal_stress_of_the_point_is_that_at_the_peak(void **context)
{
    (void)context;
    go_to_the_end_of_reversal();
    now.grains.place[3][2] = 0.01; // nothing above the plane
    clod_ring_shear_branch(&now.test, 4e3, &now.state);
    look_while(CLOD_RING_SHEAR_REDUCE, 4e3, 0.0, 1000);
    // 4.4 kPa before the peak at 1 mm, 4 kPa in its window, 3.6 kPa after
    for (int k = 0; k < 100000 && now.test.phase == CLOD_RING_SHEAR_SHEAR; k++) {
        const double off = now.test.displacement - 1e-3;
        const double x = off / 1e-3;
        look(off < -0.3e-3 ? 4.4e3 : off > 0.3e-3 ? 3.6e3 : 4e3, 3.5e3 / (1.0 + x * x));
    }
    assert_true(fabs(now.test.point_normal / 4e3 - 1.0) < 1e-9);
    // a load of 4 kPa on the whole area, less the lid of 1 kg
    assert_true(fabs(now.test.hanger_force - (4e3 * AREA - 9.81)) < 1e-9);
}

static void braking_is_no_shear_back(void **context)
{
    (void)context;
    go_to_the_end_of_preshear();
    clod_ring_shear_reverse(&now.test, &now.state);
    while (now.wall[0].spin > 0.0) { // 0.15 mm forward
        look(PRESHEAR, 3e3);
    }
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_REVERSE);
    assert_true(now.test.displacement == 0.0);
}

static void a_lid_that_meets_no_bed_stops_the_test(void **context)
{
    (void)context;
    char text[256];
    look_while(CLOD_RING_SHEAR_FILL, 0.0, 0.0, 1000);
    assert_false(clod_ring_shear_trouble(&now.test, text, sizeof text));
    // bars of 6 mm above and below and a grain of 6 mm: 18 mm; from 45 mm down at 0.1 m/s
    const double from = LID_START + now.wall[2].shift.z;
    int looks = 0;
    while (!look(0.0, 0.0)) {
        looks++;
    }
    assert_true(fabs(from - looks * 200 * DT * 0.1 - 0.018) < 2.1e-4 + 200 * DT * 0.1);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_DONE);
    assert_true(clod_ring_shear_trouble(&now.test, text, sizeof text));
    assert_non_null(strstr(text, "too few grains"));
}

static void reversal_that_never_ends_is_told(void **context)
{
    (void)context;
    go_to_the_end_of_preshear();
    clod_ring_shear_reverse(&now.test, &now.state);
    look_while(CLOD_RING_SHEAR_REVERSE, PRESHEAR, 3e3, 100000);
    assert_int_equal(now.test.flags, CLOD_RING_SHEAR_NO_REVERSAL);
    clod_ring_shear_branch(&now.test, 4e3, &now.state);
    assert_int_equal(now.test.flags, 0); // of the reversal, not of the point
}

static void shear_without_a_peak_is_told(void **context)
{
    (void)context;
    go_to_the_end_of_reversal();
    clod_ring_shear_branch(&now.test, 4e3, &now.state);
    look_while(CLOD_RING_SHEAR_REDUCE, 4e3, 0.0, 1000);
    for (int k = 0; k < 100000 && now.test.phase == CLOD_RING_SHEAR_SHEAR; k++) {
        look(4e3, 1e6 * now.test.displacement);
    }
    assert_int_equal(now.test.flags, CLOD_RING_SHEAR_NO_PEAK);
    assert_true(now.row[CLOD_RING_SHEAR_DISPLACEMENT] > 5e-3);
    // the last 0.2 mm before 5 mm: 4.9 kPa
    assert_true(fabs(now.test.point_shear / 4.9e3 - 1.0) < 0.01);
    // 0.5 kg above the plane at most
    assert_true(fabs(now.test.point_normal - 4e3) < 0.06 * 4e3);
}

static void reduced_load_that_is_never_reached_is_told(void **context)
{
    (void)context;
    go_to_the_end_of_reversal();
    clod_ring_shear_branch(&now.test, 4e3, &now.state);
    now.test.settle_max = 0.7;
    const double before = (double)now.state.step * now.state.dt;
    look_while(CLOD_RING_SHEAR_REDUCE, 6e3, 0.0, 100000);
    assert_int_equal(now.test.flags, CLOD_RING_SHEAR_NOT_SETTLED);
    assert_true(fabs((double)now.state.step * now.state.dt - before - 0.7) <
                201.0 * now.state.dt);
}

int main(void)
{
#define T(name) cmocka_unit_test_setup(name, make_cell)
    const struct CMUnitTest tests[] = {
        T(geometry_is_that_of_the_cell),
        T(filling_waits_for_rest),
        T(filling_that_never_rests_is_told),
        T(lid_carries_then_the_load_is_raised),
        T(stresses_are_forces_and_torques_over_the_area),
        T(sums_begin_anew_after_every_look),
        T(speed_rises_without_a_blow),
        T(reversal_ends_without_shear_stress),
        T(point_reduces_and_shears_to_the_peak),
        T(the_normal_stress_of_the_point_is_that_at_the_peak),
        T(braking_is_no_shear_back),
        T(a_lid_that_meets_no_bed_stops_the_test),
        T(reversal_that_never_ends_is_told),
        T(shear_without_a_peak_is_told),
        T(reduced_load_that_is_never_reached_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
