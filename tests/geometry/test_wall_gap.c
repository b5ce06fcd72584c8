// Distances from shapes: closed forms, and properties that any exact distance has: unit normal,
// the foot of the normal is on the surface, no point of the surface is nearer (sampled), and
// the distance changes at most as fast as the point moves (continuity over faces, edges,
// corners).

#include "base/random.h"
#include "geometry/wall_gap.h"
#include "geometry/wall_pose.h"
#include "support/check.h"

static double uniform(uint64_t item, uint64_t draw)
{
    return clod_random_uniform(7, CLOD_RANDOM_TEST, item, draw);
}

static void assert_gap(const clod_shape *s, clod_vec3 p, double distance, clod_vec3 normal)
{
    const clod_gap gap = clod_wall_gap(s, p);
    check_close(gap.distance, distance, 1e-14);
    check_close(gap.normal.x, normal.x, 1e-14);
    check_close(gap.normal.y, normal.y, 1e-14);
    check_close(gap.normal.z, normal.z, 1e-14);
}

/** A right-handed frame in general position. */
static void tilt(clod_vec3 axis[3])
{
    const clod_vec3 turn = clod_vec3_unit((clod_vec3){1.0, -2.0, 0.5});
    axis[0] = clod_vec3_rotate((clod_vec3){1.0, 0.0, 0.0}, turn, 0.7);
    axis[1] = clod_vec3_rotate((clod_vec3){0.0, 1.0, 0.0}, turn, 0.7);
    axis[2] = clod_vec3_rotate((clod_vec3){0.0, 0.0, 1.0}, turn, 0.7);
}

static clod_shape upright(clod_shape_kind kind)
{
    return (clod_shape){.kind = kind,
                        .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
}

static clod_shape box_1_2_3(void)
{
    clod_shape s = upright(CLOD_SHAPE_BOX);
    s.half[0] = 1.0;
    s.half[1] = 2.0;
    s.half[2] = 3.0;
    return s;
}

static clod_shape annulus_1_2(void)
{
    clod_shape s = upright(CLOD_SHAPE_ANNULUS);
    s.inner = 1.0;
    s.outer = 2.0;
    return s;
}

static clod_shape tube(clod_side side)
{
    clod_shape s = upright(CLOD_SHAPE_CYLINDER);
    s.outer = 2.0;
    s.half[2] = 1.5;
    s.side = side;
    return s;
}

// By hand: a plane through (0, 0, 1) facing down.
static void plane_is_signed(void **state)
{
    (void)state;
    clod_shape s = upright(CLOD_SHAPE_PLANE);
    s.center = (clod_vec3){0.0, 0.0, 1.0};
    s.axis[2] = (clod_vec3){0.0, 0.0, -1.0};
    assert_gap(&s, (clod_vec3){5.0, -3.0, 0.25}, 0.75, (clod_vec3){0.0, 0.0, -1.0});
    assert_gap(&s, (clod_vec3){5.0, -3.0, 1.5}, -0.5, (clod_vec3){0.0, 0.0, -1.0});
}

// By hand: faces, an edge (3, 4, 5 triangle), a corner (1, 2, 2: 3), and inside.
static void box_has_faces_edges_corners_and_an_inside(void **state)
{
    (void)state;
    const clod_shape s = box_1_2_3();
    assert_gap(&s, (clod_vec3){1.5, 0.0, 0.0}, 0.5, (clod_vec3){1.0, 0.0, 0.0});
    assert_gap(&s, (clod_vec3){0.0, -2.5, 1.0}, 0.5, (clod_vec3){0.0, -1.0, 0.0});
    assert_gap(&s, (clod_vec3){4.0, 6.0, 0.0}, 5.0, (clod_vec3){0.6, 0.8, 0.0});
    assert_gap(&s, (clod_vec3){-2.0, 4.0, -5.0}, 3.0,
               (clod_vec3){-1.0 / 3.0, 2.0 / 3.0, -2.0 / 3.0});
    assert_gap(&s, (clod_vec3){-0.75, 0.5, 0.0}, -0.25, (clod_vec3){-1.0, 0.0, 0.0});
    assert_gap(&s, (clod_vec3){0.25, 0.5, 2.75}, -0.25, (clod_vec3){0.0, 0.0, 1.0});
}

// By hand: both sides of the ring, the rims from inside and outside (3, 4, 5), the hole's
// centre.
static void annulus_acts_from_both_sides_and_at_its_rims(void **state)
{
    (void)state;
    const clod_shape s = annulus_1_2();
    assert_gap(&s, (clod_vec3){0.0, 1.5, 0.3}, 0.3, (clod_vec3){0.0, 0.0, 1.0});
    assert_gap(&s, (clod_vec3){0.0, 1.5, -0.3}, 0.3, (clod_vec3){0.0, 0.0, -1.0});
    assert_gap(&s, (clod_vec3){5.0, 0.0, 4.0}, 5.0, (clod_vec3){0.6, 0.0, 0.8});
    assert_gap(&s, (clod_vec3){0.7, 0.0, 0.4}, 0.5, (clod_vec3){-0.6, 0.0, 0.8});
    check_close(clod_wall_gap(&s, (clod_vec3){0.0, 0.0, 0.0}).distance, 1.0, 1e-15);
    clod_shape disc = upright(CLOD_SHAPE_DISC);
    disc.outer = 2.0;
    assert_gap(&disc, (clod_vec3){0.0, 0.0, 0.3}, 0.3, (clod_vec3){0.0, 0.0, 1.0});
    assert_gap(&disc, (clod_vec3){0.0, -5.0, -4.0}, 5.0, (clod_vec3){0.0, -0.6, -0.8});
}

// By hand: the shell has radius 2 and goes from z = 0 to 3.
static void cylinder_acts_inside_outside_and_at_its_rims(void **state)
{
    (void)state;
    const clod_shape s = tube(CLOD_SIDE_INSIDE);
    assert_gap(&s, (clod_vec3){1.5, 0.0, 1.0}, 0.5, (clod_vec3){-1.0, 0.0, 0.0});
    assert_gap(&s, (clod_vec3){0.0, 2.5, 1.0}, 0.5, (clod_vec3){0.0, 1.0, 0.0});
    assert_gap(&s, (clod_vec3){5.0, 0.0, 7.0}, 5.0, (clod_vec3){0.6, 0.0, 0.8});
    assert_gap(&s, (clod_vec3){1.4, 0.0, -0.8}, 1.0, (clod_vec3){-0.6, 0.0, -0.8});
    // on the surface itself the stated side decides
    assert_gap(&s, (clod_vec3){2.0, 0.0, 1.0}, 0.0, (clod_vec3){-1.0, 0.0, 0.0});
    const clod_shape outside = tube(CLOD_SIDE_OUTSIDE);
    assert_gap(&outside, (clod_vec3){2.0, 0.0, 1.0}, 0.0, (clod_vec3){1.0, 0.0, 0.0});
}

/** The shapes above, moved and turned into general position. */
static size_t all_shapes(clod_shape shapes[6])
{
    shapes[0] = upright(CLOD_SHAPE_PLANE);
    shapes[1] = box_1_2_3();
    shapes[2] = annulus_1_2();
    shapes[3] = tube(CLOD_SIDE_INSIDE);
    shapes[4] = tube(CLOD_SIDE_OUTSIDE);
    shapes[5] = upright(CLOD_SHAPE_DISC);
    shapes[5].outer = 1.5;
    for (size_t s = 0; s < 6; s++) {
        tilt(shapes[s].axis);
        shapes[s].center = (clod_vec3){0.3, -0.2, 0.5};
    }
    shapes[1].kind = CLOD_SHAPE_BAR;
    return 6;
}

static clod_vec3 random_point(uint64_t item)
{
    return (clod_vec3){10.0 * (uniform(item, 0) - 0.5), 10.0 * (uniform(item, 1) - 0.5),
                       10.0 * (uniform(item, 2) - 0.5)};
}

static void normal_is_unit_and_its_foot_is_on_the_surface(void **state)
{
    (void)state;
    clod_shape shapes[6];
    const size_t count = all_shapes(shapes);
    for (size_t s = 0; s < count; s++) {
        for (uint64_t i = 0; i < 20000; i++) {
            const clod_vec3 p = random_point(i);
            const clod_gap gap = clod_wall_gap(&shapes[s], p);
            check_close(clod_vec3_length(gap.normal), 1.0, 1e-12);
            const clod_vec3 foot = clod_vec3_axpy(p, -gap.distance, gap.normal);
            check_close(clod_wall_gap(&shapes[s], foot).distance, 0.0, 1e-12);
        }
    }
}

// A distance never changes faster than the point moves: no jump at any face, edge, corner or
// rim.
static void distance_is_continuous_everywhere(void **state)
{
    (void)state;
    clod_shape shapes[6];
    const size_t count = all_shapes(shapes);
    for (size_t s = 0; s < count; s++) {
        for (uint64_t i = 0; i < 20000; i++) {
            const clod_vec3 p = random_point(i);
            const double size = i % 2 == 0 ? 1e-6 : 1.0;
            const clod_vec3 step = clod_vec3_scale(random_point(i + 1000000), size);
            const clod_vec3 q = clod_vec3_add(p, step);
            const double change =
                clod_wall_gap(&shapes[s], q).distance - clod_wall_gap(&shapes[s], p).distance;
            assert_true(fabs(change) <= clod_vec3_length(step) * (1.0 + 1e-9) + 1e-14);
        }
    }
}

/** A random point of the surface, in the shape's own frame. */
static clod_vec3 surface_point(const clod_shape *s, uint64_t item)
{
    const double u = uniform(item, 3);
    const double v = uniform(item, 4);
    const double angle = 2.0 * M_PI * u;
    double l[3];
    if (s->kind == CLOD_SHAPE_BAR) {
        const int face = (int)(6.0 * uniform(item, 5));
        for (int a = 0; a < 3; a++) {
            l[a] = s->half[a] * (2.0 * (a == (face + 1) % 3 ? u : v) - 1.0);
        }
        l[face % 3] = face < 3 ? s->half[face % 3] : -s->half[face % 3];
    } else if (s->kind == CLOD_SHAPE_CYLINDER) {
        l[0] = s->outer * cos(angle);
        l[1] = s->outer * sin(angle);
        l[2] = 2.0 * s->half[2] * v;
    } else {
        const double rho = s->inner + v * (s->outer - s->inner);
        l[0] = rho * cos(angle);
        l[1] = rho * sin(angle);
        l[2] = 0.0;
    }
    clod_vec3 p = s->center;
    for (int a = 0; a < 3; a++) {
        p = clod_vec3_axpy(p, l[a], s->axis[a]);
    }
    return p;
}

static void no_sampled_point_of_the_surface_is_nearer(void **state)
{
    (void)state;
    clod_shape shapes[6];
    const size_t count = all_shapes(shapes);
    for (size_t s = 1; s < count; s++) { // a plane is endless
        for (uint64_t i = 0; i < 40; i++) {
            const clod_vec3 p = random_point(i);
            double nearest = HUGE_VAL;
            for (uint64_t k = 0; k < 40000; k++) {
                const clod_vec3 d = clod_vec3_sub(p, surface_point(&shapes[s], k));
                nearest = fmin(nearest, clod_vec3_length(d));
            }
            const double distance = fabs(clod_wall_gap(&shapes[s], p).distance);
            assert_true(distance <= nearest + 1e-12);
            assert_true(nearest < distance + 0.1); // the sample's spacing
        }
    }
}

// By hand: a cylinder of no length and an annulus of no width are the ring x2 + y2 = 4, z = 0.
static void shell_of_no_length_is_a_ring(void **state)
{
    (void)state;
    clod_shape s = upright(CLOD_SHAPE_CYLINDER);
    for (int k = 0; k < 2; k++) {
        s.outer = 2.0;
        s.inner = k == 0 ? 0.0 : 2.0;
        s.kind = k == 0 ? CLOD_SHAPE_CYLINDER : CLOD_SHAPE_ANNULUS;
        assert_gap(&s, (clod_vec3){5.0, 0.0, 4.0}, 5.0, (clod_vec3){0.6, 0.0, 0.8});
        assert_gap(&s, (clod_vec3){0.0, 0.5, -2.0}, 2.5, (clod_vec3){0.0, -0.6, -0.8});
    }
}

static clod_wall turned_wall(void)
{
    return (clod_wall){.spin_axis = clod_vec3_unit((clod_vec3){1.0, 2.0, -0.5}),
                       .spin_point = {0.1, 0.2, -0.3},
                       .shift = {1.0, -2.0, 0.5},
                       .angle = 2.3};
}

// Rodrigues' formula of base/vec3.h, written independently, is the other way to turn a point.
static void pose_turns_about_the_spin_point_and_back(void **state)
{
    (void)state;
    const clod_wall wall = turned_wall();
    const clod_wall_pose pose = clod_wall_pose_now(&wall);
    const clod_vec3 p = {0.7, -0.4, 1.1};
    const clod_vec3 arm = clod_vec3_sub(p, wall.spin_point);
    const clod_vec3 turned = clod_vec3_rotate(arm, wall.spin_axis, wall.angle);
    const clod_vec3 origin = clod_vec3_add(wall.spin_point, wall.shift);
    const clod_vec3 back = clod_wall_to_frame(&pose, clod_vec3_add(origin, turned));
    check_close(clod_vec3_length(clod_vec3_sub(back, p)), 0.0, 1e-15);
    const clod_vec3 forth = clod_wall_to_space(&pose, arm);
    check_close(clod_vec3_length(clod_vec3_sub(forth, turned)), 0.0, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plane_is_signed),
        cmocka_unit_test(box_has_faces_edges_corners_and_an_inside),
        cmocka_unit_test(annulus_acts_from_both_sides_and_at_its_rims),
        cmocka_unit_test(cylinder_acts_inside_outside_and_at_its_rims),
        cmocka_unit_test(shell_of_no_length_is_a_ring),
        cmocka_unit_test(normal_is_unit_and_its_foot_is_on_the_surface),
        cmocka_unit_test(distance_is_continuous_everywhere),
        cmocka_unit_test(no_sampled_point_of_the_surface_is_nearer),
        cmocka_unit_test(pose_turns_about_the_spin_point_and_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
