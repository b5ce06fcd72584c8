// Poses of walls: any orientation, and axes of spin that change. Shapes are found where a
// product of rotation matrices puts them, and nothing jumps when an axis changes.

#include "base/random.h"
#include "geometry/wall_pose.h"
#include "geometry/wall_rows.h"
#include "support/check.h"

enum { POINTS = 500 };

static double between(double from, double to, uint64_t item, uint64_t draw)
{
    return from + (to - from) * clod_random_uniform(31, CLOD_RANDOM_TEST, item, draw);
}

static clod_vec3 random_vector(uint64_t item, uint64_t draw)
{
    return (clod_vec3){between(-2.0, 2.0, item, draw), between(-2.0, 2.0, item, draw + 1),
                       between(-2.0, 2.0, item, draw + 2)};
}

static double apart(clod_vec3 a, clod_vec3 b)
{
    return clod_vec3_length(clod_vec3_sub(a, b));
}

/** A box, and a disc about the z axis through the spin point. */
static clod_wall make_wall(clod_shape shapes[2])
{
    const clod_vec3 x = {1.0, 0.0, 0.0}, y = {0.0, 1.0, 0.0}, z = {0.0, 0.0, 1.0};
    shapes[0] = (clod_shape){.kind = CLOD_SHAPE_BOX,
                             .center = {0.5, 0.2, -0.3},
                             .axis = {x, y, z},
                             .half = {0.3, 0.7, 0.1}};
    shapes[1] = (clod_shape){
        .kind = CLOD_SHAPE_DISC, .center = {0.1, 0.2, 0.9}, .axis = {x, y, z}, .outer = 0.6};
    clod_wall wall = {.spin_axis = z,
                      .spin_point = {0.1, 0.2, 0.3},
                      .shift = {0.4, -0.5, 0.6},
                      .shapes = shapes,
                      .shape_count = 2};
    clod_wall_find_symmetry(&wall);
    return wall;
}

/** Rodrigues' rotation is the quaternion's. */
static void quaternions_turn_as_rotations_do(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < POINTS; k++) {
        const clod_vec3 axis = clod_vec3_unit(random_vector(k, 0));
        const clod_vec3 other = clod_vec3_unit(random_vector(k, 3));
        const clod_vec3 p = random_vector(k, 6);
        const double a = between(-7.0, 7.0, k, 9), b = between(-7.0, 7.0, k, 10);
        const clod_quat one = clod_quat_about(axis, a), two = clod_quat_about(other, b);
        const clod_vec3 expected = clod_vec3_rotate(clod_vec3_rotate(p, axis, a), other, b);
        check_close(apart(clod_quat_rotate(clod_quat_product(two, one), p), expected), 0.0,
                    1e-14);
        double r[3][3];
        clod_quat_matrix(two, r);
        const clod_vec3 q = {r[0][0] * p.x + r[0][1] * p.y + r[0][2] * p.z,
                             r[1][0] * p.x + r[1][1] * p.y + r[1][2] * p.z,
                             r[2][0] * p.x + r[2][1] * p.y + r[2][2] * p.z};
        check_close(apart(q, clod_vec3_rotate(p, other, b)), 0.0, 1e-14);
    }
}

/** Gaps at a point of space are those of the given shapes at the point taken back. */
static void check_gaps(const clod_wall *wall, clod_vec3 (*back)(clod_vec3 p))
{
    clod_wall one = *wall;
    const clod_walls walls = {.count = 1, .wall = &one};
    clod_wall_rows rows;
    assert_true(clod_wall_rows_init(&rows, &walls));
    for (uint64_t k = 0; k < POINTS; k++) {
        const clod_vec3 p = random_vector(k, 20);
        for (int32_t s = 0; s < wall->shape_count; s++) {
            const clod_gap gap = clod_wall_rows_gap(&rows, 0, s, (double[3]){p.x, p.y, p.z});
            const clod_gap given = clod_wall_gap(&wall->shapes[s], back(p));
            check_close(gap.distance, given.distance, 1e-13);
        }
    }
    clod_wall_rows_fini(&rows);
}

static const clod_vec3 AXIS = {0.6, 0.0, 0.8};

/** Into the frame of a wall that is turned by 0.9 about AXIS and then by 0.5 about z. */
static clod_vec3 back_of_oriented(clod_vec3 p)
{
    const clod_vec3 origin = {0.5, -0.3, 0.9}, point = {0.1, 0.2, 0.3};
    const clod_vec3 z = {0.0, 0.0, 1.0};
    const clod_vec3 arm = clod_vec3_rotate(clod_vec3_sub(p, origin), z, -0.5);
    return clod_vec3_add(point, clod_vec3_rotate(arm, AXIS, -0.9));
}

static void orientation_turns_before_the_spin(void **state)
{
    (void)state;
    clod_shape shapes[2];
    clod_wall wall = make_wall(shapes);
    assert_true(shapes[1].symmetric && !shapes[0].symmetric);
    clod_wall_set_orientation(&wall, clod_quat_about(AXIS, 0.9));
    assert_false(shapes[1].symmetric); // its axis is not the wall's any more
    wall.angle = 0.5;
    check_gaps(&wall, back_of_oriented);
}

/** A wall that tumbles: turned by 0.7 about one axis, then by 1.1 about another one. */
static clod_vec3 back_of_tumbled(clod_vec3 p)
{
    const clod_vec3 first = {0.5, -0.3, 0.9}, second = {-0.2, 0.1, 0.4};
    const clod_vec3 z = {0.0, 0.0, 1.0}, point = {0.1, 0.2, 0.3};
    p = clod_vec3_add(second, clod_vec3_rotate(clod_vec3_sub(p, second), AXIS, -1.1));
    return clod_vec3_add(point, clod_vec3_rotate(clod_vec3_sub(p, first), z, -0.7));
}

static void a_wall_may_turn_about_another_axis(void **state)
{
    (void)state;
    clod_shape shapes[2];
    clod_wall wall = make_wall(shapes);
    wall.angle = 0.7;
    const clod_wall before = wall;
    clod_wall_set_spin_axis(&wall, AXIS, (clod_vec3){-0.2, 0.1, 0.4});
    assert_true(wall.angle == 0.0);
    const clod_wall_pose was = clod_wall_pose_now(&before), is = clod_wall_pose_now(&wall);
    for (uint64_t k = 0; k < POINTS; k++) { // it has not moved
        const clod_vec3 p = random_vector(k, 30);
        check_close(apart(clod_wall_point_to_space(&was, p), clod_wall_point_to_space(&is, p)),
                    0.0, 1e-14);
    }
    wall.angle = 1.1;
    check_gaps(&wall, back_of_tumbled);
}

/** Ten thousand changes of axis: a rotation is left, to rounding. */
static void many_changes_keep_a_rotation(void **state)
{
    (void)state;
    clod_shape shapes[2];
    clod_wall wall = make_wall(shapes);
    for (uint64_t k = 0; k < 10000; k++) {
        wall.angle += 0.1;
        clod_wall_set_spin_axis(&wall, clod_vec3_unit(random_vector(k, 40)),
                                random_vector(k, 43));
    }
    const clod_quat q = wall.orientation;
    check_close(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z, 1.0, 1e-15);
    const clod_wall_pose pose = clod_wall_pose_now(&wall);
    const clod_vec3 p = {0.3, 0.1, -0.7};
    check_close(apart(clod_wall_to_frame(&pose, clod_wall_point_to_space(&pose, p)), p), 0.0,
                1e-12);
}

/** The bound of speed holds for every point of a shape that is turned aside. */
static void speed_bound_knows_the_orientation(void **state)
{
    (void)state;
    clod_shape shapes[2];
    clod_wall wall = make_wall(shapes);
    wall.spin = 3.0;
    clod_wall_set_orientation(&wall, clod_quat_about((clod_vec3){0.0, 1.0, 0.0}, 1.4));
    const double bound = clod_wall_speed_bound(&wall);
    const clod_wall_pose pose = clod_wall_pose_now(&wall);
    double most = 0.0;
    for (int corner = 0; corner < 8; corner++) {
        clod_vec3 p = shapes[0].center;
        p.x += (corner & 1) != 0 ? 0.3 : -0.3;
        p.y += (corner & 2) != 0 ? 0.7 : -0.7;
        p.z += (corner & 4) != 0 ? 0.1 : -0.1;
        const clod_vec3 at = clod_wall_point_to_space(&pose, p);
        most = fmax(most, clod_vec3_length(clod_wall_velocity_at(&wall, at)));
    }
    for (int k = 0; k < 100; k++) { // the rim of the disc
        const double a = 2.0 * M_PI * k / 100.0;
        const clod_vec3 p = {0.1 + 0.6 * cos(a), 0.2 + 0.6 * sin(a), 0.9};
        const clod_vec3 at = clod_wall_point_to_space(&pose, p);
        most = fmax(most, clod_vec3_length(clod_wall_velocity_at(&wall, at)));
    }
    check_at_least(bound * (1.0 + 1e-12), most);
    check_at_least(most, 0.5 * bound); // and is not far away
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quaternions_turn_as_rotations_do),
        cmocka_unit_test(orientation_turns_before_the_spin),
        cmocka_unit_test(a_wall_may_turn_about_another_axis),
        cmocka_unit_test(many_changes_keep_a_rotation),
        cmocka_unit_test(speed_bound_knows_the_orientation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
