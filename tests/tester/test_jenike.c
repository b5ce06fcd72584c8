// The procedure of the shear test in a Jenike cell, on fabricated states: what the walls feel
// is prescribed. What it shares with the ring shear test is in test_ring_shear.c.

#include <stdio.h>
#include <string.h>

#include "support/cell_state.h"
#include "support/check.h"
#include "tester/ring_shear.h"

// The cell of 3.75 in: A = pi 0.047625^2 m2.
#define RADIUS 0.047625
#define AREA (3.14159265358979323846 * RADIUS * RADIUS)
#define DT 1e-5
#define LID_START 0.05
#define BASE_HEIGHT 0.0127
#define PRESHEAR 10e3
#define SPEED 0.01
#define GRAIN_MASS 0.2
#define ANGLE 0.1 ///< rad, of a twist

enum { BASE, BASE_RING, SHEAR_RING, LID, WALLS };

typedef struct cell {
    clod_case from;
    clod_state state;
    clod_wall wall[WALLS];
    clod_shape shape[WALLS][2];
    cell_grains grains;
    clod_ring_shear test;
    double row[CLOD_RING_SHEAR_COLUMNS];
} cell;

static cell now;

/** Four grains of 50 g: three below the shear plane, one above, its top at 30 mm. */
static void make(int64_t twists)
{
    static const char *const NAMES[] = {"base", "base_ring", "shear_ring", "lid"};
    memset(&now, 0, sizeof now);
    now.from.jenike = (clod_case_jenike){.present = true,
                                         .fill_max = 0.6,
                                         .settle_max = 0.3,
                                         .diameter = 2.0 * RADIUS,
                                         .base_height = BASE_HEIGHT,
                                         .ring_height = 0.0159,
                                         .rim = 3.2e-3,
                                         .offset = 3e-3,
                                         .twists = twists,
                                         .twist_angle = ANGLE,
                                         .lid_mass = 0.5,
                                         .programme = {.preshear_stress = PRESHEAR,
                                                       .speed = SPEED,
                                                       .block_displacement = 0.2e-3,
                                                       .steady_blocks = 3,
                                                       .steady_tolerance = 0.02,
                                                       .preshear_max = 4e-3,
                                                       .shear_max = 2e-3,
                                                       .beyond_peak = 0.4e-3,
                                                       .peak_window = 0.1e-3}};
    for (int w = 0; w < WALLS; w++) {
        snprintf(now.wall[w].name, sizeof now.wall[w].name, "%s", NAMES[w]);
        now.wall[w].shapes = now.shape[w];
        now.wall[w].shape_count = w == BASE || w == LID ? 1 : 2;
    }
    now.shape[SHEAR_RING][1] = (clod_shape){.kind = CLOD_SHAPE_ANNULUS,
                                            .center = {-3e-3, 0.0, BASE_HEIGHT},
                                            .inner = RADIUS,
                                            .outer = RADIUS + 3.2e-3};
    now.shape[LID][0] = (clod_shape){
        .kind = CLOD_SHAPE_ANNULUS, .center = {-3e-3, 0.0, LID_START}, .outer = RADIUS};
    now.wall[LID].load = CLOD_LOAD_STRESS;
    cell_state_make(&now.state, &now.grains, 0.027, GRAIN_MASS, now.wall, WALLS, DT);
    clod_ring_shear_begin(&now.test, &now.from, &now.state);
}

/** Advance by the planned steps under a stress at the lid and a shear stress, then look. */
static bool look(double lid_stress, double shear_stress)
{
    const int64_t steps = clod_ring_shear_plan(&now.test, &now.state);
    const double n = (double)steps;
    const double drag = shear_stress * AREA * n;
    assert_true(steps > 0);
    for (int w = 0; w < WALLS; w++) {
        now.wall[w].sum_steps += steps;
        now.wall[w].shift.x += now.wall[w].velocity.x * n * DT;
        now.wall[w].shift.z += now.wall[w].velocity.z * n * DT;
        now.wall[w].angle += now.wall[w].spin * n * DT;
    }
    now.wall[LID].sum_force.z += lid_stress * AREA * n;
    now.wall[BASE].sum_force.z -= 0.8 * (lid_stress * AREA + GRAIN_MASS * 9.81) * n;
    now.wall[BASE_RING].sum_force.z -= 0.2 * (lid_stress * AREA + GRAIN_MASS * 9.81) * n;
    // solid that is dragged along +x holds back what drags it: -x; whatever the shares
    now.wall[SHEAR_RING].sum_force.x -= 0.7 * drag;
    now.wall[LID].sum_force.x -= 0.3 * drag;
    now.wall[BASE_RING].sum_force.x += 0.6 * drag;
    now.wall[BASE].sum_force.x += 0.4 * drag;
    now.wall[SHEAR_RING].sum_torque.z += 17.0 * n; // no torque counts
    now.state.step += steps;
    return clod_ring_shear_sample(&now.test, &now.state, now.row);
}

/** Look until a phase is left; the number of looks, at most `most`. */
static int look_while(clod_ring_shear_phase phase, double lid_stress, double shear_stress,
                      int most)
{
    int looks = 0;
    while (now.test.phase == phase && looks < most) {
        look(lid_stress, shear_stress);
        looks++;
    }
    assert_int_not_equal(now.test.phase, phase);
    return looks;
}

static void go_to_the_end_of_consolidation(void)
{
    look_while(CLOD_RING_SHEAR_FILL, 0.0, 0.0, 1000);
    look_while(CLOD_RING_SHEAR_LOWER, 0.1 * PRESHEAR, 0.0, 1000);
    look_while(CLOD_RING_SHEAR_CONSOLIDATE, PRESHEAR, 0.0, 1000);
}

static void go_to_preshear(void)
{
    make(0);
    go_to_the_end_of_consolidation();
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_PRESHEAR);
}

static void lid_comes_down_to_the_grains(void **state)
{
    (void)state;
    make(0);
    look_while(CLOD_RING_SHEAR_FILL, 0.0, 0.0, 1000);
    check_close(LID_START + now.wall[LID].shift.z, 0.030, 1e-15); // no bars
    check_relative(now.wall[LID].velocity.z, -0.1, 1e-12);
    assert_true(now.wall[LID].velocity.x == 0.0 && now.wall[SHEAR_RING].velocity.x == 0.0);
}

// tau = -F_x(ring and lid)/A, sigma = F_z(lid)/A + g m_above/A: 50 g above the shear plane.
static void stresses_are_forces_over_the_area(void **state)
{
    (void)state;
    go_to_preshear();
    look(9e3, 6e3);
    const double *row = now.row;
    check_relative(now.test.area, AREA, 1e-14);
    check_relative(row[CLOD_RING_SHEAR_NORMAL_STRESS], 9e3 + 0.05 * 9.81 / AREA, 1e-12);
    check_relative(row[CLOD_RING_SHEAR_NORMAL_STRESS_BASE], 9e3 + 0.2 * 9.81 / AREA, 1e-12);
    check_relative(row[CLOD_RING_SHEAR_SHEAR_STRESS], 6e3, 1e-12);
    check_relative(row[CLOD_RING_SHEAR_SHEAR_STRESS_BASE], 6e3, 1e-12);
    const double height = LID_START + now.wall[LID].shift.z;
    check_relative(row[CLOD_RING_SHEAR_HEIGHT], height, 1e-14);
    check_relative(row[CLOD_RING_SHEAR_BULK_DENSITY], GRAIN_MASS / (AREA * height), 1e-12);
    const double speed = row[CLOD_RING_SHEAR_SPEED]; // that of the look, not the next one's
    assert_true(speed > 0.0 && speed < now.wall[SHEAR_RING].velocity.x);
    check_relative(row[CLOD_RING_SHEAR_POWER], 6e3 * AREA * speed, 1e-12);
    assert_true(row[CLOD_RING_SHEAR_PHASE] == CLOD_RING_SHEAR_PRESHEAR);
    // the load makes up for the solid above
    check_relative(now.wall[LID].load_force, PRESHEAR * AREA - 0.05 * 9.81, 1e-12);
}

static void ring_and_lid_move_as_one_and_the_base_stands(void **state)
{
    (void)state;
    go_to_preshear();
    double travelled = 0.0;
    double before = now.wall[SHEAR_RING].velocity.x;
    while (before < SPEED) {
        const double time = (double)now.state.step * DT;
        look(PRESHEAR, 6e3);
        const double interval = (double)now.state.step * DT - time;
        travelled += before * interval;
        const double speed = now.wall[SHEAR_RING].velocity.x;
        assert_true(speed > before && speed - before <= 3.0 * interval * (1.0 + 1e-12));
        assert_true(now.wall[LID].velocity.x == speed);
        before = speed;
    }
    assert_true(before == SPEED);
    check_close(now.test.displacement, travelled, 1e-15);
    check_close(now.wall[SHEAR_RING].shift.x, now.wall[LID].shift.x, 1e-15);
    for (int w = 0; w < WALLS; w++) {
        const clod_wall *wall = &now.wall[w];
        assert_true(wall->velocity.y == 0.0 && wall->spin == 0.0);
        assert_true(w >= SHEAR_RING || wall->velocity.x == 0.0);
    }
}

static void preshear_ends_when_its_travel_is_used_up(void **state)
{
    (void)state;
    go_to_preshear();
    while (now.test.phase == CLOD_RING_SHEAR_PRESHEAR) {
        look(PRESHEAR, 1e3 + 2e6 * now.test.displacement);
    }
    assert_int_equal(now.test.flags, CLOD_RING_SHEAR_NOT_STEADY);
    // at 4 mm, to half a sample of 4 um and what whole numbers of steps leave; as far is the ring
    // from its start
    check_close(now.test.preshear_displacement, 4e-3, 0.02e-3);
    check_close(now.wall[SHEAR_RING].shift.x, now.test.preshear_displacement, 1e-9);
}

static void point_goes_back_reduces_and_shears_to_the_peak(void **state)
{
    (void)state;
    go_to_preshear();
    look_while(CLOD_RING_SHEAR_PRESHEAR, PRESHEAR, 6e3, 100000);
    assert_int_equal(now.test.flags, 0);
    check_relative(now.test.preshear_shear, 6e3, 1e-12);
    clod_ring_shear_reverse(&now.test, &now.state);
    for (int k = 0; k < 200; k++) { // from 10 mm/s to -0.33 mm/s at 3 m/s2 takes 3.4 ms
        look(PRESHEAR, 3e3);
    }
    check_relative(now.wall[SHEAR_RING].velocity.x, -0.033 * SPEED, 1e-12);
    check_relative(now.wall[LID].velocity.x, -0.033 * SPEED, 1e-12);
    look(PRESHEAR, -1.0);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_DONE);
    clod_ring_shear_branch(&now.test, 4e3, &now.state);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_REDUCE);
    look(7e3, 0.0);
    assert_true(now.wall[SHEAR_RING].velocity.x == 0.0 && now.wall[LID].velocity.x == 0.0);
    look_while(CLOD_RING_SHEAR_REDUCE, 4e3, 0.0, 1000);
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_SHEAR);
    while (now.test.phase == CLOD_RING_SHEAR_SHEAR) { // a smooth peak of 3.5 kPa at 0.5 mm
        const double x = (now.test.displacement - 0.5e-3) / 0.5e-3;
        look(4e3, 3.5e3 / (1.0 + x * x));
    }
    assert_int_equal(now.test.flags, 0);
    // smoothed over 0.1 mm: lower by 0.1^2/24 of the curvature 2 * 3.5 kPa/0.5^2 mm2, 0.33 %
    check_relative(now.test.point_shear, 3.5e3 * (1.0 - 0.0033), 1e-3);
    check_close(now.test.point_displacement, 0.5e-3, 1e-5);
    check_relative(now.test.shear_speed, SPEED * sqrt(0.4), 1e-12);
}

// Steady after 1 mm, 2 mm behind the base ring: 2 mm back would be 0.8 mm more than the rim.
static void shearing_back_stops_where_the_rims_end(void **state)
{
    (void)state;
    go_to_preshear();
    look_while(CLOD_RING_SHEAR_PRESHEAR, PRESHEAR, 6e3, 100000);
    assert_true(now.wall[SHEAR_RING].shift.x < 1.1e-3);
    clod_ring_shear_reverse(&now.test, &now.state);
    look_while(CLOD_RING_SHEAR_REVERSE, PRESHEAR, 3e3, 1000000); // never falls to zero
    assert_int_equal(now.test.flags, CLOD_RING_SHEAR_NO_REVERSAL);
    const double look_way = 0.033 * SPEED * 200 * DT;
    check_close(-3e-3 + now.wall[SHEAR_RING].shift.x, -3.2e-3 - 0.5 * look_way,
                0.5 * look_way * (1.0 + 1e-9));
    clod_ring_shear_branch(&now.test, 4e3, &now.state);
    look(7e3, 0.0);
    assert_true(now.wall[SHEAR_RING].velocity.x == 0.0);
}

/** One twist is +angle, -angle, 0: the way of the edge is 4 R angle, without the turning. */
static void lid_is_twisted_to_and_fro(void **state)
{
    (void)state;
    make(2);
    go_to_the_end_of_consolidation();
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_TWIST);
    assert_string_equal(clod_ring_shear_phase_name(CLOD_RING_SHEAR_TWIST), "twist");
    const double begun = (double)now.state.step * DT;
    double least = 0.0;
    double most = 0.0;
    int turns = 0;
    double spin = 0.0;
    while (now.test.phase == CLOD_RING_SHEAR_TWIST) {
        const double time = (double)now.state.step * DT;
        look(PRESHEAR, 0.0);
        const double interval = (double)now.state.step * DT - time;
        const double change = fabs(now.wall[LID].spin - spin) * RADIUS;
        check_at_most(change, 3.0 * interval * (1.0 + 1e-12)); // no blow
        turns += now.wall[LID].spin * spin < 0.0;
        spin = now.wall[LID].spin;
        check_at_most(fabs(spin) * RADIUS, SPEED * (1.0 + 1e-12));
        if (fabs(now.wall[LID].angle) >= ANGLE && now.wall[LID].angle * spin > 0.0) {
            // it turns round as soon as that is seen
            check_at_most(fabs(spin) * RADIUS, SPEED - 0.5 * 3.0 * interval);
        }
        least = fmin(least, now.wall[LID].angle);
        most = fmax(most, now.wall[LID].angle);
        check_relative(now.wall[LID].load_force, PRESHEAR * AREA - 0.05 * 9.81, 1e-12);
    }
    assert_int_equal(now.test.phase, CLOD_RING_SHEAR_PRESHEAR);
    assert_int_equal(turns, 4);
    // beyond the angle by a look of 2 ms and the way of braking, 10 mm/s * 3.3 ms/2: 0.04 mm
    const double beyond = SPEED * (200 * DT + SPEED / 3.0) / RADIUS;
    check_close(most, ANGLE + 0.5 * beyond, 0.5 * beyond);
    check_close(least, -ANGLE - 0.5 * beyond, 0.5 * beyond);
    check_close(now.wall[LID].angle, 0.5 * beyond, 0.5 * beyond);
    const double took = (double)now.state.step * DT - begun;
    check_relative(took, 2.0 * 4.0 * ANGLE * RADIUS / SPEED, 0.02);
    assert_true(now.wall[LID].spin == 0.0);
    assert_true(now.wall[SHEAR_RING].spin == 0.0); // held by the operator
    assert_true(now.test.displacement == 0.0);     // twisting is no shear
}

static void a_lid_that_sinks_to_the_base_ring_stops_the_test(void **state)
{
    char text[256];
    (void)state;
    make(0);
    look_while(CLOD_RING_SHEAR_FILL, 0.0, 0.0, 1000);
    assert_false(clod_ring_shear_trouble(&now.test, text, sizeof text));
    // base ring of 12.7 mm and a grain of 6 mm: 18.7 mm; from 30 mm down at 0.1 m/s
    const double from = LID_START + now.wall[LID].shift.z;
    int looks = 0;
    while (!look(0.0, 0.0)) {
        looks++;
    }
    check_close(from - looks * 200 * DT * 0.1, 0.0187, 2.1e-4 + 200 * DT * 0.1);
    assert_true(clod_ring_shear_trouble(&now.test, text, sizeof text));
    assert_non_null(strstr(text, "Raise jenike.grain_count"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lid_comes_down_to_the_grains),
        cmocka_unit_test(stresses_are_forces_over_the_area),
        cmocka_unit_test(ring_and_lid_move_as_one_and_the_base_stands),
        cmocka_unit_test(preshear_ends_when_its_travel_is_used_up),
        cmocka_unit_test(point_goes_back_reduces_and_shears_to_the_peak),
        cmocka_unit_test(shearing_back_stops_where_the_rims_end),
        cmocka_unit_test(lid_is_twisted_to_and_fro),
        cmocka_unit_test(a_lid_that_sinks_to_the_base_ring_stops_the_test),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
