// Belts in the hands of the library's owner: that of a whole wall and those of its shapes.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/sim_made.h"

#define R 3e-3
#define G 9.81
#define MASS (2481.3 * 4.1887902047863905 * 27e-9)
#define K 2e4
#define DT 1e-5
#define U 0.7

/** Two plates side by side, one wall; a grain is put onto each of them. */
static const char CASE[] =
    "materials: {ore: {density: 2481.3 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 2e4 N/m, restitution: 0.3, friction: 0.5}}\n"
    "time: {step: 1e-5 s}\n"
    "domain: {min: [-2 m, -1 m, -1 m], max: [2 m, 1 m, 1 m]}\n"
    "stages: [{name: all, duration: 1 s}]\n"
    "walls:\n"
    "  plates: {material: ore, shapes: [\n"
    "    {box: {center: [0 m, 0 m, -5 mm], size: [3 m, 0.2 m, 10 mm]}},\n"
    "    {box: {center: [0 m, 0.5 m, -5 mm], size: [3 m, 0.2 m, 10 mm]}}]}\n"
    "grains:\n"
    "  - {material: ore, count: 2, radius: {distribution: uniform, min: 3 mm, max: 3 mm},\n"
    "     region: {box: {min: [-10 mm, -10 mm, 100 mm], max: [10 mm, 10 mm, 150 mm]}}}\n";

/** Of three numbers of the grain on a plate. */
static double *numbers(clod_sim *sim, const char *name, int plate)
{
    clod_sim_view view, at;
    CHECK(clod_sim_array(sim, name, &view, &status));
    CHECK(clod_sim_array(sim, "position", &at, &status));
    const size_t row = (clod_sim_row(&at, 0)[1] > 0.25) == (plate == 1) ? 0 : 1;
    return clod_sim_row(&view, row);
}

/** Both grains lie on their plates with the overlap that carries them. */
static clod_sim *make(void)
{
    clod_sim *sim = sim_made(CASE, 1);
    clod_sim_view at, force;
    CHECK(clod_sim_array(sim, "position", &at, &status));
    CHECK(clod_sim_array(sim, "force", &force, &status));
    for (size_t g = 0; g < 2; g++) {
        double *p = clod_sim_row(&at, g);
        p[0] = 0.0;
        p[1] = g == 0 ? 0.0 : 0.5;
        p[2] = R - MASS * G / K;
        clod_sim_row(&force, g)[2] = 0.0;
    }
    CHECK(clod_sim_positions_changed(sim, &status));
    return sim;
}

/** Share of a belt's velocity that a ball without rolling friction ends with: 2/7, but for the
 *  overlap, by which its lever is shorter. Friction acts at the surface, about which the ball
 *  has no angular momentum. */
static double share(void)
{
    const double lever = R - MASS * G / K;
    return 1.0 / (1.0 + lever * lever / (0.4 * R * R));
}

/** Slides first, with friction mu m g; then rolls with the share of the belt's velocity. */
static void check_carried(clod_sim *sim, int plate)
{
    clod_sim_wall wall;
    CHECK(clod_sim_advance(sim, 2000, &status));
    CHECK(clod_sim_wall_look(sim, 0, &wall, &status));
    const double both = wall.force[2] / (-MASS * G);
    check_relative(both, 2.0, 1e-3);
    check_relative(numbers(sim, "velocity", plate)[0], 0.5 * G * 2000 * DT, 1e-3);
    CHECK(clod_sim_advance(sim, 58000, &status));
    check_relative(numbers(sim, "velocity", plate)[0], U * share(), 1e-4);
    check_close(share(), 2.0 / 7.0, 1e-4);
    CHECK(clod_sim_wall_look(sim, 0, &wall, &status));
    check_close(wall.position[0], 0.0, 0.0);
}

/** The belt of a whole wall moves all its shapes. */
static void a_surface_velocity_carries_all(void **state)
{
    (void)state;
    clod_sim *sim = make();
    CHECK(clod_sim_set_wall_surface_velocity(sim, 0, (double[3]){U, 0.0, 0.0}, &status));
    clod_sim_wall wall;
    CHECK(clod_sim_wall_look(sim, 0, &wall, &status));
    assert_true(wall.surface_velocity[0] == U && wall.material_velocity[0] == U);
    assert_true(wall.velocity[0] == 0.0);
    check_carried(sim, 0);
    check_relative(numbers(sim, "velocity", 1)[0], U * share(), 1e-4);
    CHECK(clod_sim_wall_look(sim, 0, &wall, &status));
    check_close(wall.force[0], 0.0, 1e-3 * MASS * G); // it rolls
    CHECK(clod_sim_set_wall_surface_velocity(sim, 0, (double[3]){0.0}, &status));
    CHECK(clod_sim_advance(sim, 60000, &status));
    check_close(numbers(sim, "velocity", 0)[0], 0.0, 1e-4 * U);
    clod_sim_destroy(&sim);
}

/** Constant, along a direction that the plate projects, and turning about an axis 1 m below:
 *  the same belt, of one shape alone. It ends, and with it the ball's motion. */
static void a_belt_moves_its_shape_alone(void **state)
{
    (void)state;
    static const clod_sim_belt BELTS[] = {
        {.velocity = {U, 0.0, 0.0}},
        {.speed = U, .direction = {3.0, 0.0, -6.0}},
        {.spin = U, .spin_axis = {0.0, 2.0, 0.0}, .spin_point = {0.0, 0.0, -1.0}},
    };
    for (size_t k = 0; k < 3; k++) {
        for (int plate = 0; plate < 2; plate++) {
            clod_sim *sim = make();
            CHECK(clod_sim_advance(sim, 100, &status)); // the plates stand, and have been met
            CHECK(clod_sim_set_belt(sim, 0, plate, &BELTS[k], &status));
            check_carried(sim, plate);
            check_close(numbers(sim, "velocity", 1 - plate)[0], 0.0, 1e-12);
            CHECK(clod_sim_set_belt(sim, 0, plate, &(clod_sim_belt){0}, &status));
            CHECK(clod_sim_advance(sim, 60000, &status));
            check_close(numbers(sim, "velocity", plate)[0], 0.0, 1e-4 * U);
            clod_sim_destroy(&sim);
        }
    }
}

/** What was set is what is looked at, with directions of length 1; checkpoints hold it. */
static void belts_are_kept(void **temporary)
{
    const char *folder = *temporary;
    clod_sim *sim = make(), *again = make();
    const clod_sim_belt given = {.velocity = {0.1, 0.2, 0.3},
                                 .speed = 0.4,
                                 .direction = {0.0, 3.0, 4.0},
                                 .spin = 0.5,
                                 .spin_axis = {0.0, 0.0, -2.0},
                                 .spin_point = {0.6, 0.7, 0.8}};
    clod_sim_belt seen;
    CHECK(clod_sim_set_belt(sim, 0, 1, &given, &status));
    CHECK(clod_sim_advance(sim, 1000, &status));
    CHECK(clod_sim_write_checkpoint(sim, folder, &status));
    CHECK(clod_sim_read_checkpoint(again, folder, NULL, &status));
    CHECK(clod_sim_belt_look(again, 0, 1, &seen, &status));
    assert_memory_equal(seen.velocity, given.velocity, sizeof seen.velocity);
    assert_true(seen.speed == 0.4 && seen.spin == 0.5);
    check_close(seen.direction[1], 0.6, 1e-15);
    check_close(seen.direction[2], 0.8, 1e-15);
    check_close(seen.spin_axis[2], -1.0, 0.0);
    assert_memory_equal(seen.spin_point, given.spin_point, sizeof seen.spin_point);
    CHECK(clod_sim_belt_look(again, 0, 0, &seen, &status));
    assert_memory_equal(&seen, &(clod_sim_belt){0}, sizeof seen);
    CHECK(clod_sim_advance(sim, 1000, &status));
    CHECK(clod_sim_advance(again, 1000, &status));
    assert_true(numbers(sim, "velocity", 1)[1] > 0.01);
    assert_memory_equal(numbers(sim, "velocity", 1), numbers(again, "velocity", 1), 24);
    clod_sim_destroy(&sim);
    clod_sim_destroy(&again);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    clod_sim *sim = make();
    const clod_sim_belt good = {.velocity = {1.0, 0.0, 0.0}};
    static const struct {
        clod_sim_belt belt;
        const char *words;
    } WRONG[] = {{{.velocity = {NAN, 0.0, 0.0}}, "velocity is (nan"},
                 {{.direction = {0.0, INFINITY, 0.0}}, "direction is (0, inf"},
                 {{.spin_axis = {NAN, 0.0, 0.0}}, "spin_axis is (nan"},
                 {{.spin_point = {NAN, 0.0, 0.0}}, "spin_point is (nan"},
                 {{.speed = NAN, .direction = {1.0, 0.0, 0.0}}, "speed is nan"},
                 {{.spin = INFINITY, .spin_axis = {1.0, 0.0, 0.0}}, "spin is inf"},
                 {{.speed = 1.0}, "speed of 1 m/s has no direction"},
                 {{.spin = 2.0}, "spin of 2 rad/s has no spin_axis"}};
    clod_sim_belt seen;
    for (size_t k = 0; k < sizeof WRONG / sizeof *WRONG; k++) {
        expect_refused(clod_sim_set_belt(sim, 0, 0, &WRONG[k].belt, &status), WRONG[k].words);
        CHECK(clod_sim_belt_look(sim, 0, 0, &seen, &status));
        assert_memory_equal(&seen, &(clod_sim_belt){0}, sizeof seen);
    }
    expect_refused(clod_sim_set_belt(sim, 1, 0, &good, &status), "no wall 1; there are 1");
    expect_refused(clod_sim_set_belt(sim, 0, 2, &good, &status), "no shape 2; it has 2");
    expect_refused(clod_sim_set_belt(sim, 0, 0, NULL, &status), "belt is NULL");
    expect_refused(clod_sim_belt_look(sim, 0, -1, &seen, &status), "no shape -1");
    expect_refused(clod_sim_belt_look(sim, 0, 0, NULL, &status), "belt is NULL");
    expect_refused(clod_sim_set_wall_surface_velocity(sim, 0, WRONG[0].belt.velocity, &status),
                   "velocity is (nan");
    expect_refused(clod_sim_set_wall_surface_velocity(sim, 0, NULL, &status),
                   "velocity is NULL");
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_surface_velocity_carries_all),
        cmocka_unit_test(a_belt_moves_its_shape_alone),
        cmocka_unit_test_setup_teardown(belts_are_kept, temp_folder_make, temp_folder_remove),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
