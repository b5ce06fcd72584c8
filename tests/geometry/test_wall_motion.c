// Motion of walls (src/state/walls.c).

#include "base/memory.h"
#include "base/random.h"
#include "state/walls.h"
#include "support/check.h"

static clod_wall moving_wall(void)
{
    return (clod_wall){.velocity = {1.0, 0.0, 0.0},
                       .surface_velocity = {0.0, 0.5, 0.0},
                       .spin = 2.0,
                       .spin_axis = {0.0, 0.0, 1.0},
                       .spin_point = {1.0, 0.0, 0.0},
                       .shift = {0.0, 1.0, 0.0},
                       .load_axis = {0.0, 0.0, -1.0},
                       .servo_velocity = 0.25};
}

// By hand: the axis stands at (1, 1); at (4, 1) the arm is 3 along x, so spin adds 6 along y.
static void velocity_adds_translation_servo_spin_and_surface(void **state)
{
    (void)state;
    clod_wall wall = moving_wall();
    clod_shape shape = {0};
    wall.shapes = &shape;
    wall.shape_count = 1;
    const clod_vec3 at = {4.0, 1.0, 7.0}, up = {0.0, 0.0, 1.0}, y = {0.0, 1.0, 0.0};
    const clod_vec3 rigid = clod_wall_velocity_at(&wall, at);
    assert_true(rigid.x == 1.0 && rigid.y == 6.0 && rigid.z == -0.25);
    const clod_vec3 v = clod_wall_material_velocity(&wall, 0, at, up);
    assert_true(v.x == 1.0 && v.y == 6.5 && v.z == -0.25);
    const clod_vec3 across = clod_wall_material_velocity(&wall, 0, at, y);
    assert_true(across.x == 1.0 && across.y == 6.0 && across.z == -0.25); // no belt there
}

// By hand: a box with half sizes 3, 4, 1 about the axis reaches 5; 2 rad/s makes 10 m/s.
static void speed_bound_takes_the_farthest_corner(void **state)
{
    (void)state;
    clod_shape shapes[2] = {
        {.kind = CLOD_SHAPE_BOX,
         .center = {1.0, 0.0, 9.0},
         .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
         .half = {3.0, 4.0, 1.0}},
        {.kind = CLOD_SHAPE_ANNULUS, .symmetric = true, .outer = 100.0},
    };
    clod_wall wall = moving_wall();
    wall.shapes = shapes;
    wall.shape_count = 2;
    check_close(clod_wall_speed_bound(&wall), 1.0 + 0.25 + 10.0, 1e-14);
    shapes[0].symmetric = true;
    check_close(clod_wall_speed_bound(&wall), 1.25, 1e-14);
}

// A tilted shell beside the axis: points of it, sampled, are never faster than the bound.
static void speed_bound_holds_for_sampled_points(void **state)
{
    (void)state;
    const clod_vec3 axis = clod_vec3_unit((clod_vec3){1.0, 1.0, 0.5});
    const clod_vec3 e = clod_vec3_unit(clod_vec3_cross(axis, (clod_vec3){0.0, 0.0, 1.0}));
    clod_shape shape = {.kind = CLOD_SHAPE_CYLINDER,
                        .center = {2.0, 1.0, 0.0},
                        .axis = {e, clod_vec3_cross(axis, e), axis},
                        .outer = 0.7,
                        .half = {0.0, 0.0, 1.1}};
    clod_wall wall = {.spin = -3.0, .spin_axis = {0.0, 0.0, 1.0}, .shapes = &shape};
    wall.shape_count = 1;
    const double bound = clod_wall_speed_bound(&wall);
    double fastest = 0.0;
    for (uint64_t i = 0; i < 20000; i++) {
        const double angle = 2.0 * M_PI * clod_random_uniform(1, CLOD_RANDOM_TEST, i, 0);
        const double length = 2.2 * clod_random_uniform(1, CLOD_RANDOM_TEST, i, 1);
        clod_vec3 p = clod_vec3_axpy(shape.center, length, axis);
        p = clod_vec3_axpy(p, 0.7 * cos(angle), shape.axis[0]);
        p = clod_vec3_axpy(p, 0.7 * sin(angle), shape.axis[1]);
        fastest = fmax(fastest, clod_vec3_length(clod_wall_velocity_at(&wall, p)));
    }
    assert_true(fastest <= bound);
    assert_true(bound <= 1.2 * fastest);
}

// The wide end of a cone decides, at whichever end it is: 2 rad/s times 3 m, or 5 m off the
// axis.
static void speed_bound_takes_the_wider_end_of_a_cone(void **state)
{
    (void)state;
    clod_shape cone = {.kind = CLOD_SHAPE_CONE,
                       .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                       .outer = 1.0,
                       .inner = 3.0,
                       .half = {0.0, 0.0, 2.0}};
    clod_wall wall = {
        .spin = 2.0, .spin_axis = {0.0, 0.0, 1.0}, .shape_count = 1, .shapes = &cone};
    check_close(clod_wall_speed_bound(&wall), 6.0, 1e-15);
    cone.outer = 5.0;
    check_close(clod_wall_speed_bound(&wall), 10.0, 1e-15);
}

static clod_wall shaker(void)
{
    return (clod_wall){.velocity = {0.0, 0.01, 0.0},
                       .spin = 0.2,
                       .spin_axis = {0.0, 0.0, 1.0},
                       .load_axis = {0.0, 0.0, -1.0},
                       .servo_velocity = 0.03,
                       .oscillation = {.direction = {1.0, 0.0, 0.0},
                                       .amplitude = 2e-3,
                                       .angle = 0.05,
                                       .frequency = 50.0,
                                       .phase = 0.7}};
}

// x = a sin(2 pi f t + phase) beside the steady motion, and v = a w cos(2 pi f t + phase).
static void oscillation_follows_its_closed_form(void **state)
{
    (void)state;
    clod_wall wall = shaker();
    const double dt = 1e-5;
    const double w = 2.0 * M_PI * 50.0;
    clod_wall_start(&wall);
    check_relative(wall.shift.x, 2e-3 * sin(0.7), 1e-15);
    check_relative(wall.angle, 0.05 * sin(0.7), 1e-15);
    check_relative(wall.sway_velocity.x, 2e-3 * w * cos(0.7), 1e-15);
    for (int64_t step = 1; step <= 5000; step++) {
        clod_wall_move(&wall, dt, step);
        const double t = (double)step * dt;
        check_close(wall.shift.x, 2e-3 * sin(w * t + 0.7), 1e-16);
        check_close(wall.shift.y, 0.01 * t, 1e-15);
        check_close(wall.shift.z, -0.03 * t, 1e-15);
        check_close(wall.angle, 0.2 * t + 0.05 * sin(w * t + 0.7), 1e-14);
        // in the middle of the step, up to (w dt)^2/24 = 4e-7 of itself
        const double cosine = cos(w * (t - 0.5 * dt) + 0.7);
        check_close(wall.sway_velocity.x, 2e-3 * w * cosine, 2e-3 * w * 5e-7);
        check_close(wall.sway_spin, 0.05 * w * cosine, 0.05 * w * 5e-7);
    }
}

// What contacts see is what the wall does: velocity times dt is the displacement of each step.
static void velocity_of_an_oscillation_is_its_displacement(void **state)
{
    (void)state;
    clod_wall wall = shaker();
    clod_wall_start(&wall);
    for (int64_t step = 1; step <= 2000; step++) {
        const clod_wall before = wall;
        clod_wall_move(&wall, 2e-4, step); // 100 steps in a period
        const clod_vec3 v = clod_wall_velocity(&wall);
        const clod_vec3 moved = clod_vec3_sub(wall.shift, before.shift);
        check_close(clod_vec3_length(clod_vec3_axpy(moved, -2e-4, v)), 0.0, 1e-17);
        check_close(wall.angle - before.angle, 2e-4 * clod_wall_spin(&wall), 1e-15);
        const clod_vec3 at = {1.0, 2.0, 3.0};
        const clod_vec3 arm = clod_vec3_sub(at, wall.shift);
        const clod_vec3 seen = clod_vec3_sub(clod_wall_velocity_at(&wall, at), v);
        check_close(seen.x, -clod_wall_spin(&wall) * arm.y, 1e-14);
        check_close(seen.y, clod_wall_spin(&wall) * arm.x, 1e-14);
    }
}

// After a million periods the phase of the case's own numbers, in extended precision, is met to
// the rounding of one sine; and a place has the same bits however the wall got there.
static void oscillation_does_not_drift(void **state)
{
    (void)state;
    const double dt = 1470863.0 * 0x1p-37; // 10.7 us in 21 bits
    clod_wall wall = shaker();
    wall.velocity.y = wall.spin = wall.servo_velocity = 0.0;
    const double per_step = 50.0 * dt;
    const int64_t million = (int64_t)(1e6 / per_step);
    for (int64_t step = million; step < million + 3000; step++) {
        clod_wall_move(&wall, dt, step);
        const long double cycles = (long double)step * per_step; // exact: 27 and 31 bits
        const long double part = cycles - floorl(cycles);
        const double expected = 2e-3 * sin(2.0 * M_PI * (double)part + 0.7);
        check_close(wall.shift.x, expected, 4e-18);
        clod_wall jumped = shaker();
        jumped.velocity.y = jumped.spin = jumped.servo_velocity = 0.0;
        clod_wall_move(&jumped, dt, step);
        assert_true(jumped.shift.x == wall.shift.x && jumped.angle == wall.angle);
        assert_true(jumped.sway_velocity.x == wall.sway_velocity.x);
    }
}

// By hand: 2 pi f times (amplitude + angle times the reach of 1 m), beside 0.01 and 0.03 and
// 0.2 rad/s; no step of a corner is longer than the bound allows.
static void speed_bound_holds_for_an_oscillation(void **state)
{
    (void)state;
    clod_shape box = {.kind = CLOD_SHAPE_BOX,
                      .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                      .half = {0.6, 0.8, 0.1}};
    clod_wall wall = shaker();
    wall.shapes = &box;
    wall.shape_count = 1;
    const double bound = clod_wall_speed_bound(&wall);
    check_relative(bound, 100.0 * M_PI * (2e-3 + 0.05) + 0.04 + 0.2, 1e-14);
    clod_vec3 corner[2] = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    double fastest = 0.0;
    for (int64_t step = 1; step <= 20000; step++) {
        clod_wall_move(&wall, 1e-5, step);
        const clod_vec3 arm = {0.6, 0.8, 0.1};
        corner[step % 2] =
            clod_vec3_add(clod_vec3_rotate(arm, wall.spin_axis, wall.angle), wall.shift);
        const double way = clod_vec3_length(clod_vec3_sub(corner[0], corner[1]));
        fastest = step > 1 ? fmax(fastest, way / 1e-5) : 0.0;
    }
    check_at_most(fastest, bound);
    check_at_least(fastest, 0.9 * bound);
}

static void copy_is_deep_and_sums_start_anew(void **state)
{
    (void)state;
    clod_walls walls = {.count = 1, .wall = clod_memory_alloc(1, sizeof(clod_wall))};
    walls.wall[0] = moving_wall();
    walls.wall[0].shapes = clod_memory_alloc(1, sizeof(clod_shape));
    walls.wall[0].shape_count = 1;
    walls.wall[0].shapes[0].outer = 3.0;
    walls.wall[0].sum_steps = 5;
    walls.wall[0].sum_force.x = 2.0;
    walls.wall[0].sum_torque.z = 2.0;
    walls.wall[0].sum_power = 2.0;
    clod_walls copy;
    clod_status status = {0};
    assert_true(clod_walls_copy(&copy, &walls, &status));
    walls.wall[0].shapes[0].outer = 4.0;
    assert_true(copy.wall[0].shapes[0].outer == 3.0);
    assert_true(copy.wall[0].spin == 2.0);
    clod_walls_reset_sums(&copy);
    assert_true(copy.wall[0].sum_steps == 0 && copy.wall[0].sum_force.x == 0.0);
    assert_true(copy.wall[0].sum_torque.z == 0.0 && copy.wall[0].sum_power == 0.0);
    assert_true(walls.wall[0].sum_steps == 5);
    clod_walls_fini(&copy);
    clod_walls_fini(&walls);
    assert_true(walls.wall == NULL && walls.count == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(velocity_adds_translation_servo_spin_and_surface),
        cmocka_unit_test(speed_bound_takes_the_farthest_corner),
        cmocka_unit_test(speed_bound_holds_for_sampled_points),
        cmocka_unit_test(speed_bound_takes_the_wider_end_of_a_cone),
        cmocka_unit_test(oscillation_follows_its_closed_form),
        cmocka_unit_test(velocity_of_an_oscillation_is_its_displacement),
        cmocka_unit_test(oscillation_does_not_drift),
        cmocka_unit_test(speed_bound_holds_for_an_oscillation),
        cmocka_unit_test(copy_is_deep_and_sums_start_anew),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
