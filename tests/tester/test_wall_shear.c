// The procedure of the wall friction test on fabricated states: what the walls feel is prescribed.

#include "tester/wall_shear.h"

#include <stdio.h>
#include <string.h>

#include "support/cell_state.h"
#include "support/check.h"

// A straight cell of 100 mm: A = pi 0.05^2 = 7.853982e-3 m2.
#define AREA 7.853981633974483e-3
#define DT 1e-5
#define LID_START 0.06
#define SPEED 0.03
#define GRAIN_MASS 0.4
#define WEIGHT (GRAIN_MASS * 9.81 / AREA) ///< Pa
#define FRICTION 0.25

enum { PLATE, SIDES, LID };

typedef struct cell {
    clod_case from;
    clod_state state;
    clod_wall wall[3];
    clod_shape shape[3];
    cell_grains grains;
    double stresses[3];
    clod_wall_shear test;
    double row[CLOD_WALL_SHEAR_COLUMNS];
    double friction; ///< tau/sigma that the plate feels
} cell;

static cell now;

/** Four grains of 0.1 kg and 3 mm, the highest with its top at 50 mm. */
static int make_cell(void **context)
{
    static const char *const NAMES[] = {"plate", "sides", "lid"};
    (void)context;
    memset(&now, 0, sizeof now);
    now.friction = FRICTION;
    memcpy(now.stresses, (double[]){5e3, 20e3, 10e3}, sizeof now.stresses);
    now.from.wall_friction = (clod_case_wall_friction){.present = true,
                                                       .cell = CLOD_CASE_CELL_STRAIGHT,
                                                       .outer_radius = 0.05,
                                                       .speed = SPEED,
                                                       .block_displacement = 1e-3,
                                                       .steady_blocks = 4,
                                                       .steady_tolerance = 0.02,
                                                       .shear_min = 6e-3,
                                                       .shear_max = 12e-3,
                                                       .fill_max = 0.6,
                                                       .settle_max = 0.3,
                                                       .wall_stresses = now.stresses,
                                                       .wall_stress_count = 3};
    for (int w = 0; w < 3; w++) {
        snprintf(now.wall[w].name, sizeof now.wall[w].name, "%s", NAMES[w]);
        now.wall[w].shapes = &now.shape[w];
        now.wall[w].shape_count = 1;
        now.wall[w].load_axis = (clod_vec3){0.0, 0.0, -1.0};
    }
    now.shape[LID] = (clod_shape){.kind = CLOD_SHAPE_ANNULUS, .center = {0.0, 0.0, LID_START}};
    now.wall[LID].load = CLOD_LOAD_STRESS;
    now.wall[LID].area = AREA;
    cell_state_make(&now.state, &now.grains, 0.047, GRAIN_MASS, now.wall, 3, DT);
    clod_wall_shear_begin(&now.test, &now.from, &now.state);
    return 0;
}

/** Advance by the planned steps under a force of the lid [Pa], then look. */
static bool look(double lid)
{
    const int64_t steps = clod_wall_shear_plan(&now.test, &now.state);
    const double n = (double)steps;
    const double sigma = lid + WEIGHT;
    assert_true(steps > 0);
    for (int w = 0; w < 3; w++) {
        now.wall[w].sum_steps += steps;
    }
    const double tau = now.wall[PLATE].velocity.x > 0.0 || now.wall[PLATE].spin > 0.0
                           ? now.friction * sigma
                           : 0.0;
    now.wall[LID].sum_force = (clod_vec3){0.25 * tau * AREA * n, 0.0, lid * AREA * n};
    now.wall[SIDES].sum_force.x = 0.75 * tau * AREA * n;
    now.wall[PLATE].sum_force = (clod_vec3){-tau * AREA * n, 0.0, -sigma * AREA * n};
    now.wall[PLATE].sum_torque.z = -tau * AREA * n * now.test.mean_radius;
    now.state.step += steps;
    return clod_wall_shear_sample(&now.test, &now.state, now.row);
}

/** Look under the load that the lid is told, until a phase is left. */
static void look_while(clod_wall_shear_phase phase)
{
    for (int looks = 0; now.test.phase == phase && looks < 100000; looks++) {
        look(now.wall[LID].load_force / AREA);
    }
    assert_int_not_equal(now.test.phase, phase);
}

static void go_to_run_in(void)
{
    look_while(CLOD_WALL_SHEAR_FILL);
    assert_int_equal(now.test.phase, CLOD_WALL_SHEAR_DONE);
    clod_wall_shear_branch(&now.test, &now.state);
    look(2e3);
    assert_int_equal(now.test.phase, CLOD_WALL_SHEAR_CONSOLIDATE);
    look_while(CLOD_WALL_SHEAR_CONSOLIDATE);
    assert_int_equal(now.test.phase, CLOD_WALL_SHEAR_RUN_IN);
}

static void filling_ends_with_the_cell_as_it_was(void **context)
{
    (void)context;
    look_while(CLOD_WALL_SHEAR_FILL);
    assert_int_equal(now.test.phase, CLOD_WALL_SHEAR_DONE);
    assert_int_equal(clod_wall_shear_plan(&now.test, &now.state), 0);
    assert_true(now.state.adhesion == 0.1 && now.test.flags == 0);
}

/** Largest first, whatever the order of the case. */
static void stresses_descend(void **context)
{
    (void)context;
    assert_int_equal(now.test.stress_count, 3);
    assert_true(now.test.stresses[0] == 20e3 && now.test.stresses[1] == 10e3 &&
                now.test.stresses[2] == 5e3);
}

/** The lid presses with what the weight of the solid leaves. */
static void consolidation_is_at_the_largest_stress_on_the_plate(void **context)
{
    (void)context;
    go_to_run_in();
    assert_true(now.state.adhesion == 1.0);
    check_relative(now.wall[LID].load_force, (20e3 - WEIGHT) * AREA, 1e-12);
    check_relative(now.row[CLOD_WALL_SHEAR_NORMAL_STRESS], 20e3, 1e-12);
    check_relative(now.row[CLOD_WALL_SHEAR_NORMAL_STRESS_LID], 20e3, 1e-12);
    assert_true(now.test.flags == 0);
}

/** Every stress has its run-in and its steady blocks; the plate is slower, but never stops. */
static void the_plate_shears_on_from_stress_to_stress(void **context)
{
    (void)context;
    go_to_run_in();
    const double stresses[] = {20e3, 10e3, 5e3};
    for (int k = 0; k < 3; k++) {
        assert_int_equal(now.test.phase, CLOD_WALL_SHEAR_RUN_IN);
        const double before = now.test.displacement;
        look_while(CLOD_WALL_SHEAR_RUN_IN);
        // one block of way at least, and the ramp of 20 ms: 0.6 mm
        assert_true(now.test.displacement - before >= 1e-3);
        assert_true(now.test.displacement - before < 1.5e-3);
        check_relative(now.wall[PLATE].velocity.x, SPEED * sqrt(stresses[k] / 20e3), 1e-12);
        look_while(CLOD_WALL_SHEAR_SHEAR);
        const clod_wall_shear_point *p = &now.test.point[k];
        check_relative(p->normal, stresses[k], 1e-9);
        check_relative(p->shear, FRICTION * stresses[k], 1e-9);
        assert_true(p->steady == 1);
        check_close(p->displacement, 6e-3, 0.1e-3); // shear_min: whole blocks
        // 0.4 kg on 7.854e-3 m2 and 60 mm
        check_relative(p->density, GRAIN_MASS / (AREA * LID_START) * LID_START / p->height,
                       1e-12);
    }
    assert_int_equal(now.test.phase, CLOD_WALL_SHEAR_DONE);
    assert_int_equal(now.test.at, 3);
    assert_true(now.test.flags == 0 && clod_wall_shear_progress(&now.test) == 1.0);
}

static void the_series_has_both_sides_of_the_balance(void **context)
{
    (void)context;
    go_to_run_in();
    look_while(CLOD_WALL_SHEAR_RUN_IN);
    look(20e3 - WEIGHT);
    check_relative(now.row[CLOD_WALL_SHEAR_SHEAR_STRESS], FRICTION * 20e3, 1e-12);
    check_relative(now.row[CLOD_WALL_SHEAR_SHEAR_STRESS_HELD], FRICTION * 20e3, 1e-12);
}

/** A shear stress that rises all the time ends at shear_max, with its rate. */
static void what_is_not_steady_is_told(void **context)
{
    (void)context;
    go_to_run_in();
    look_while(CLOD_WALL_SHEAR_RUN_IN);
    while (now.test.phase == CLOD_WALL_SHEAR_SHEAR) {
        now.friction = 0.1 + 10.0 * now.test.in_phase; // by 0.01 each mm
        look(20e3 - WEIGHT);
    }
    const clod_wall_shear_point *p = &now.test.point[0];
    assert_int_equal(now.test.flags, CLOD_WALL_SHEAR_NOT_STEADY);
    assert_true(p->steady == 0);
    assert_in_range((int)(1e6 * p->displacement), 11000, 12100);
    check_relative(p->rate, 10.0 * 20e3, 1e-6);
}

/** A block of 25 samples is 25 x 189 steps x 0.212 um = 1.0023 mm at 10 kPa: five of them fit into
 *  a limit of 5 mm, which is meant to be five blocks. */
static void steps_that_round_up_cost_no_block(void **context)
{
    (void)context;
    now.from.wall_friction.steady_blocks = 5;
    now.from.wall_friction.shear_min = 5e-3;
    now.from.wall_friction.shear_max = 5e-3;
    clod_wall_shear_begin(&now.test, &now.from, &now.state);
    go_to_run_in();
    for (int k = 0; k < 3; k++) {
        look_while(CLOD_WALL_SHEAR_RUN_IN);
        look_while(CLOD_WALL_SHEAR_SHEAR);
        assert_int_equal(now.test.point[k].steady, 1);
        check_close(now.test.point[k].displacement, 5e-3, 0.1e-3);
    }
    assert_true(now.test.flags == 0);
}

/** By hand: r_m = 2/3 (0.05^3 - 0.03^3)/(0.05^2 - 0.03^2) = 0.0408333 m. */
static void a_ring_turns_its_plate(void **context)
{
    (void)context;
    now.from.wall_friction.cell = CLOD_CASE_CELL_RING;
    now.from.wall_friction.inner_radius = 0.03;
    clod_wall_shear_begin(&now.test, &now.from, &now.state);
    check_relative(now.test.mean_radius, 2.0 / 3.0 * 9.8e-5 / 1.6e-3, 1e-12);
    go_to_run_in();
    look_while(CLOD_WALL_SHEAR_RUN_IN);
    check_relative(now.wall[PLATE].spin, SPEED / 0.0408333333333333, 1e-9);
    assert_true(now.wall[PLATE].velocity.x == 0.0);
    look_while(CLOD_WALL_SHEAR_SHEAR);
    check_relative(now.test.point[0].shear, FRICTION * 20e3, 1e-9);
}

static void a_lid_on_the_plate_ends_the_test(void **context)
{
    char text[512];
    (void)context;
    go_to_run_in();
    assert_false(clod_wall_shear_trouble(&now.test, text, sizeof text));
    now.wall[LID].shift.z = 0.0059 - LID_START; // a grain is 6 mm
    assert_true(look(20e3));
    assert_true(clod_wall_shear_trouble(&now.test, text, sizeof text));
    assert_non_null(strstr(text, "sank to 5.9 mm"));
    assert_non_null(strstr(text, "wall_friction.grain_count"));
}

/** What --from may change comes from the new case. */
static void another_programme_can_follow_a_filling(void **context)
{
    (void)context;
    look_while(CLOD_WALL_SHEAR_FILL);
    now.stresses[0] = 40e3;
    now.from.wall_friction.shear_max = 30e-3;
    clod_wall_shear_programme(&now.test, &now.from);
    assert_true(now.test.stresses[0] == 40e3 && now.test.shear_max == 30e-3);
    assert_int_equal(now.test.phase, CLOD_WALL_SHEAR_DONE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(filling_ends_with_the_cell_as_it_was, make_cell),
        cmocka_unit_test_setup(stresses_descend, make_cell),
        cmocka_unit_test_setup(consolidation_is_at_the_largest_stress_on_the_plate, make_cell),
        cmocka_unit_test_setup(the_plate_shears_on_from_stress_to_stress, make_cell),
        cmocka_unit_test_setup(the_series_has_both_sides_of_the_balance, make_cell),
        cmocka_unit_test_setup(what_is_not_steady_is_told, make_cell),
        cmocka_unit_test_setup(steps_that_round_up_cost_no_block, make_cell),
        cmocka_unit_test_setup(a_ring_turns_its_plate, make_cell),
        cmocka_unit_test_setup(a_lid_on_the_plate_ends_the_test, make_cell),
        cmocka_unit_test_setup(another_programme_can_follow_a_filling, make_cell),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
