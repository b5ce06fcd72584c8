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
    const clod_wall wall = moving_wall();
    const clod_vec3 v = clod_wall_velocity_at(&wall, (clod_vec3){4.0, 1.0, 7.0});
    assert_true(v.x == 1.0 && v.y == 6.5 && v.z == -0.25);
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
        cmocka_unit_test(copy_is_deep_and_sums_start_anew),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
