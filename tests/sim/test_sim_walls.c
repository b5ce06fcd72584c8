// Walls of a library's owner: any pose, an axis of turning that changes, belts of single shapes
// and shapes turned before the run, over threads and checkpoints.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/sim_made.h"

static const char CASE[] =
    "materials:\n"
    "  ore: {density: 2500 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}\n"
    "  rubber: {density: 1200 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}\n"
    "contacts:\n"
    "  default: {law: hertz, restitution: 0.5, friction: 0.3}\n"
    "domain: {min: [-5 mm, -5 mm, -5 mm], max: [25 mm, 25 mm, 90 mm]}\n"
    "stages: [{name: fall, duration: 1 s}]\n"
    "walls:\n"
    "  room:\n"
    "    material: ore\n"
    "    shapes:\n"
    "      - plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1],\n"
    "                surface: {material: rubber, speed: 0.2 m/s, direction: [1, 0, 0]}}\n"
    "      - plane: {point: [0 mm, 0 mm, 0 mm], normal: [1, 0, 0]}\n"
    "      - plane: {point: [20 mm, 0 mm, 0 mm], normal: [-1, 0, 0]}\n"
    "      - plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 1, 0]}\n"
    "      - plane: {point: [0 mm, 20 mm, 0 mm], normal: [0, -1, 0]}\n"
    "  paddle:\n"
    "    material: ore\n"
    "    shapes: [{box: {center: [0 mm, 0 mm, 0 mm], size: [16 mm, 3 mm, 2 mm]}}]\n"
    "    rotate: {axis: [0, 1, 0], angle: 30 deg}\n"
    "    move: [10 mm, 10 mm, 20 mm]\n"
    "    spin_point: [10 mm, 10 mm, 20 mm]\n"
    "grains:\n"
    "  - material: ore\n"
    "    count: 60\n"
    "    radius: {distribution: uniform, min: 1.2 mm, max: 1.5 mm}\n"
    "    region: {box: {min: [2 mm, 2 mm, 30 mm], max: [18 mm, 18 mm, 80 mm]}}\n";

static clod_sim *make(int threads)
{
    return sim_made(CASE, threads);
}

static clod_sim_wall look(const clod_sim *sim, const char *name)
{
    clod_sim_wall view;
    CHECK(clod_sim_wall_look(sim, clod_sim_wall_index(sim, name), &view, &status));
    return view;
}

/** Positions and velocities bit for bit, and what the paddle feels. */
static void assert_same(clod_sim *a, clod_sim *b)
{
    static const char *const NAMES[] = {"position", "velocity", "angular_velocity", "force"};
    for (size_t n = 0; n < sizeof NAMES / sizeof *NAMES; n++) {
        clod_sim_view x, y;
        CHECK(clod_sim_array(a, NAMES[n], &x, &status));
        CHECK(clod_sim_array(b, NAMES[n], &y, &status));
        assert_int_equal(x.rows, y.rows);
        for (size_t g = 0; g < x.rows; g++) {
            assert_memory_equal(clod_sim_row(&x, g), clod_sim_row(&y, g), 3 * sizeof(double));
        }
    }
    const clod_sim_wall p = look(a, "paddle"), q = look(b, "paddle");
    assert_memory_equal(p.force, q.force, sizeof p.force);
    assert_memory_equal(p.torque, q.torque, sizeof p.torque);
    assert_memory_equal(p.orientation, q.orientation, sizeof p.orientation);
    assert_true(p.power == q.power);
}

/** The paddle tumbles: another axis every 400 steps. */
static void tumble(clod_sim *sim, int from, int to)
{
    const int32_t paddle = clod_sim_wall_index(sim, "paddle");
    const double point[3] = {10e-3, 10e-3, 20e-3};
    for (int k = from; k < to; k++) {
        const double omega[3] = {10.0 * sin(k), 10.0 * cos(k), 4.0};
        CHECK(clod_sim_set_wall_angular_velocity(sim, paddle, omega, point, &status));
        CHECK(clod_sim_advance(sim, 400, &status));
    }
}

static double quaternion_apart(const double a[4], const double b[4])
{
    double minus = 0.0, plus = 0.0; // q and -q are the same rotation
    for (int k = 0; k < 4; k++) {
        minus = fmax(minus, fabs(a[k] - b[k]));
        plus = fmax(plus, fabs(a[k] + b[k]));
    }
    return fmin(minus, plus);
}

static void a_wall_that_tumbles_is_the_same_over_threads_and_checkpoints(void **temporary)
{
    clod_sim *a = make(1), *b = make(2), *c = make(1);
    tumble(a, 0, 12);
    tumble(b, 0, 12);
    assert_same(a, b);
    const clod_sim_wall paddle = look(a, "paddle");
    double felt = 0.0;
    for (int k = 0; k < 3; k++) {
        felt += fabs(paddle.mean_force[k]);
        check_close(paddle.position[k], 0.0, 1e-15); // it turns about its middle
    }
    assert_true(felt > 1e-5);
    const char *folder = *temporary;
    CHECK(clod_sim_write_checkpoint(b, folder, &status));
    CHECK(clod_sim_read_checkpoint(c, folder, NULL, &status));
    tumble(a, 12, 16);
    tumble(c, 12, 16);
    assert_same(a, c);
    // each leg turned by omega dt about its axis, one after the other
    double expected[4] = {1.0, 0.0, 0.0, 0.0};
    for (int k = 0; k < 16; k++) {
        const double omega[3] = {10.0 * sin(k), 10.0 * cos(k), 4.0};
        const double speed = sqrt(100.0 + 16.0), half = 200.0 * speed * clod_sim_dt(a);
        const double w = cos(half), s = sin(half) / speed;
        const double x = s * omega[0], y = s * omega[1], z = s * omega[2];
        const double *q = expected;
        const double next[4] = {w * q[0] - x * q[1] - y * q[2] - z * q[3],
                                w * q[1] + x * q[0] + y * q[3] - z * q[2],
                                w * q[2] - x * q[3] + y * q[0] + z * q[1],
                                w * q[3] + x * q[2] - y * q[1] + z * q[0]};
        memcpy(expected, next, sizeof expected);
    }
    check_close(quaternion_apart(expected, look(a, "paddle").orientation), 0.0, 1e-12);
    clod_sim_destroy(&a);
    clod_sim_destroy(&b);
    clod_sim_destroy(&c);
}

/** A wall put at a pose feels what one feels that was given there. */
static void a_wall_can_be_put_at_any_pose(void **state)
{
    (void)state;
    clod_sim *turned = make(1), *given = make(1);
    const int32_t paddle = clod_sim_wall_index(turned, "paddle");
    const double c = cos(M_PI / 12.0), s = sin(M_PI / 12.0); // 30 deg about y, there and back
    CHECK(clod_sim_set_wall_orientation(turned, paddle, (double[4]){c, 0.0, s, 0.0}, &status));
    CHECK(clod_sim_set_wall_position(turned, paddle, (double[3]){0.0, 0.0, 1e-3}, &status));
    CHECK(clod_sim_advance(turned, 10, &status));
    CHECK(clod_sim_set_wall_orientation(turned, paddle, (double[4]){2.0, 0.0, 0.0, 0.0},
                                        &status));
    CHECK(clod_sim_set_wall_position(turned, paddle, (double[3]){0.0, 0.0, 0.0}, &status));
    CHECK(clod_sim_advance(turned, 4990, &status));
    CHECK(clod_sim_advance(given, 5000, &status)); // nothing was near in the first ten steps
    assert_same(turned, given);
    clod_sim_destroy(&turned);
    clod_sim_destroy(&given);
}

#define NEEDS(call, words)                                                                     \
    do {                                                                                       \
        status = (clod_status){0};                                                             \
        assert_false(call);                                                                    \
        assert_int_equal(status.code, CLOD_USAGE);                                             \
        assert_non_null(strstr(status.text, words));                                           \
    } while (0)

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    clod_sim *sim = make(1);
    const int32_t room = clod_sim_wall_index(sim, "room");
    const double none[4] = {0.0}, wrong[4] = {1.0, NAN, 0.0, 0.0}, point[3] = {0.0};
    NEEDS(clod_sim_set_wall_orientation(sim, room, none, &status), "not all 0");
    NEEDS(clod_sim_set_wall_orientation(sim, room, wrong, &status), "finite");
    NEEDS(clod_sim_set_wall_orientation(sim, 7, wrong, &status), "no wall 7");
    NEEDS(clod_sim_set_wall_orientation(sim, room, NULL, &status), "orientation is NULL");
    NEEDS(clod_sim_set_wall_angular_velocity(sim, room, (double[3]){1.0, 0.0, 0.0}, point,
                                             &status),
          "plane");
    NEEDS(clod_sim_set_wall_angular_velocity(sim, room, wrong, point, &status), "finite");
    const clod_sim_wall view = look(sim, "room");
    assert_true(view.orientation[0] == 1.0 && view.spin == 0.0);
    clod_sim_destroy(&sim);
}

/** Every function that takes the index of a wall names one that is not there, and the number. */
static void an_unknown_wall_is_named_by_every_function(void **state)
{
    (void)state;
    static const int32_t UNKNOWN[] = {-1, 2, INT32_MAX, INT32_MIN};
    clod_sim *sim = make(1);
    const double zero[3] = {0.0}, unit[4] = {1.0, 0.0, 0.0, 0.0};
    clod_sim_belt belt = {.velocity = {1.0, 0.0, 0.0}};
    clod_sim_wall view;
    clod_sim_contact contact;
    bool found;
    for (size_t k = 0; k < sizeof UNKNOWN / sizeof *UNKNOWN; k++) {
        const int32_t w = UNKNOWN[k];
        char words[64];
        snprintf(words, sizeof words, ": there is no wall %d; there are 2", (int)w);
        NEEDS(clod_sim_wall_look(sim, w, &view, &status), words);
        NEEDS(clod_sim_set_wall_velocity(sim, w, zero, &status), words);
        NEEDS(clod_sim_set_wall_surface_velocity(sim, w, zero, &status), words);
        NEEDS(clod_sim_set_wall_spin(sim, w, 1.0, &status), words);
        NEEDS(clod_sim_set_wall_load(sim, w, 1.0, &status), words);
        NEEDS(clod_sim_set_wall_orientation(sim, w, unit, &status), words);
        NEEDS(clod_sim_set_wall_angular_velocity(sim, w, zero, zero, &status), words);
        NEEDS(clod_sim_set_wall_position(sim, w, zero, &status), words);
        NEEDS(clod_sim_set_belt(sim, w, 0, &belt, &status), words);
        NEEDS(clod_sim_belt_look(sim, w, 0, &belt, &status), words);
        NEEDS(clod_sim_wall_contact_of(sim, 1, w, 0, &contact, &found, &status), words);
    }
    CHECK(clod_sim_remove_wall(sim, "paddle", &status)); // an index is of the walls there are
    CHECK(clod_sim_change(sim, &status));
    NEEDS(clod_sim_wall_look(sim, 1, &view, &status), "no wall 1; there are 1");
    clod_sim_destroy(&sim);
}

/** A wall that is pushed by a load, and one that swings; both are driven too. */
static const char MOVED[] =
    "materials: {ore: {density: 2500 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.3}}\n"
    "time: {step: 1e-5 s}\n"
    "domain: {min: [0 mm, 0 mm, -20 mm], max: [20 mm, 20 mm, 90 mm]}\n"
    "stages: [{name: push, duration: 1 s}]\n"
    "walls:\n"
    "  floor: {material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm]}}]}\n"
    "  lid:\n"
    "    material: ore\n"
    "    shapes: [{disc: {center: [10 mm, 10 mm, 5 mm], normal: [0, 0, -1], radius: 9 mm}}]\n"
    "    load: {axis: [0, 0, -1], force: 1 N, mass: 10 g}\n"
    "  swing:\n"
    "    material: ore\n"
    "    shapes: [{box: {center: [10 mm, 10 mm, 60 mm], size: [8 mm, 8 mm, 8 mm]}}]\n"
    "    spin_axis: [0, 1, 0]\n"
    "    oscillation: {direction: [1, 0, 0], amplitude: 1 mm, angle: 0.1 rad, frequency: 30 "
    "Hz}\n"
    "grains:\n"
    "  - {material: ore, count: 3, radius: {distribution: uniform, min: 1.4 mm, max: 1.5 mm}, "
    "region: {box: {min: [4 mm, 4 mm, 0 mm], max: [16 mm, 16 mm, 4 mm]}}}\n";

/**
 * What was written is read again, whatever a servo and an oscillation add; material_velocity is
 * how far the wall goes in a step, of a wall with a load in the next one, and its belt.
 */
static void a_motion_is_read_as_it_was_written(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(MOVED, 1);
    const double drive[3] = {0.0, 0.01, 0.0}, belt[3] = {0.0, 0.0, 0.4};
    const int32_t lid = clod_sim_wall_index(sim, "lid"), swing = lid + 1;
    CHECK(clod_sim_set_wall_velocity(sim, lid, drive, &status));
    CHECK(clod_sim_set_wall_velocity(sim, swing, drive, &status));
    CHECK(clod_sim_set_wall_surface_velocity(sim, swing, belt, &status));
    CHECK(clod_sim_set_wall_spin(sim, swing, 2.0, &status));
    CHECK(clod_sim_advance(sim, 1000, &status));
    const clod_sim_wall lid_before = look(sim, "lid"), before = look(sim, "swing");
    CHECK(clod_sim_advance(sim, 1, &status));
    const clod_sim_wall lid_after = look(sim, "lid"), after = look(sim, "swing");
    assert_memory_equal(lid_after.velocity, drive, sizeof drive);
    assert_memory_equal(after.velocity, drive, sizeof drive);
    assert_memory_equal(after.surface_velocity, belt, sizeof belt);
    assert_true(after.spin == 2.0 && after.angular_velocity[1] == 2.0);
    assert_true(after.angular_velocity[0] == 0.0 && after.angular_velocity[2] == 0.0);
    for (int a = 0; a < 3; a++) {
        const double fallen = (lid_after.position[a] - lid_before.position[a]) / 1e-5;
        const double gone = (after.position[a] - before.position[a]) / 1e-5;
        check_close(lid_before.material_velocity[a], fallen, 1e-10);
        check_close(after.material_velocity[a], gone + belt[a], 1e-10);
    }
    check_close(after.material_spin, (after.angle - before.angle) / 1e-5, 1e-9);
    // they are not what was written: the load, 2 pi f A cos, and 2 pi f angle cos with f t = 0.3
    assert_true(lid_before.material_velocity[2] < -1e-3);
    check_close(after.material_velocity[0], 60.0 * M_PI * 1e-3 * cos(0.6 * M_PI), 1e-3);
    check_close(after.material_spin, 2.0 + 60.0 * M_PI * 0.1 * cos(0.6 * M_PI), 0.05);
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(
            a_wall_that_tumbles_is_the_same_over_threads_and_checkpoints, temp_folder_make,
            temp_folder_remove),
        cmocka_unit_test(a_wall_can_be_put_at_any_pose),
        cmocka_unit_test(what_cannot_be_is_refused),
        cmocka_unit_test(an_unknown_wall_is_named_by_every_function),
        cmocka_unit_test(a_motion_is_read_as_it_was_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
