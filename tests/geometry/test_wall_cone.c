// Distance from the shell of a cone: by hand (triangles 3, 4, 5), against the nearest of many
// points of the surface for random cones and points, and against the cylinder.

#include "geometry/wall_gap.h"
#include "support/check.h"
#include "support/dice.h"
#include "support/sanitized.h"

static clod_shape upright(double foot_radius, double top_radius, double length, clod_side side)
{
    return (clod_shape){.kind = CLOD_SHAPE_CONE,
                        .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                        .outer = foot_radius,
                        .inner = top_radius,
                        .half = {0.0, 0.0, 0.5 * length},
                        .side = side};
}

static void assert_gap(const clod_shape *s, clod_vec3 p, double distance, clod_vec3 normal)
{
    const clod_gap gap = clod_wall_gap(s, p);
    check_close(gap.distance, distance, 1e-14);
    check_close(gap.normal.x, normal.x, 1e-14);
    check_close(gap.normal.y, normal.y, 1e-14);
    check_close(gap.normal.z, normal.z, 1e-14);
}

// By hand: radius 1 at z = 0, 4 at z = 4; the outward normal is (0.8, -0.6).
static void shell_acts_inside_outside_and_at_its_rims(void **state)
{
    (void)state;
    const clod_shape s = upright(1.0, 4.0, 4.0, CLOD_SIDE_INSIDE);
    assert_gap(&s, (clod_vec3){2.1, 0.0, 2.3}, 0.5, (clod_vec3){-0.8, 0.0, 0.6});
    assert_gap(&s, (clod_vec3){0.0, 2.9, 1.7}, 0.5, (clod_vec3){0.0, 0.8, -0.6});
    assert_gap(&s, (clod_vec3){-7.0, 0.0, 8.0}, 5.0, (clod_vec3){-0.6, 0.0, 0.8});
    assert_gap(&s, (clod_vec3){0.4, 0.0, -0.8}, 1.0, (clod_vec3){-0.6, 0.0, -0.8});
    // on the surface itself the stated side decides
    assert_gap(&s, (clod_vec3){1.0, 0.0, 0.0}, 0.0, (clod_vec3){-0.8, 0.0, 0.6});
    const clod_shape outside = upright(1.0, 4.0, 4.0, CLOD_SIDE_OUTSIDE);
    assert_gap(&outside, (clod_vec3){1.0, 0.0, 0.0}, 0.0, (clod_vec3){0.8, 0.0, -0.6});
}

// By hand: a tip at the origin that opens upwards, and the same upside down.
static void tip_is_a_point(void **state)
{
    (void)state;
    const clod_shape up = upright(0.0, 3.0, 4.0, CLOD_SIDE_INSIDE);
    assert_gap(&up, (clod_vec3){0.0, 0.0, -2.0}, 2.0, (clod_vec3){0.0, 0.0, -1.0});
    assert_gap(&up, (clod_vec3){0.3, 0.0, -0.4}, 0.5, (clod_vec3){0.6, 0.0, -0.8});
    assert_gap(&up, (clod_vec3){0.0, 0.5, 1.5}, 0.5, (clod_vec3){0.0, -0.8, 0.6});
    const clod_shape down = upright(3.0, 0.0, 4.0, CLOD_SIDE_OUTSIDE);
    assert_gap(&down, (clod_vec3){0.0, 0.0, 6.0}, 2.0, (clod_vec3){0.0, 0.0, 1.0});
    assert_gap(&down, (clod_vec3){0.3, 0.0, 4.4}, 0.5, (clod_vec3){0.6, 0.0, 0.8});
    const clod_gap axis = clod_wall_gap(&up, (clod_vec3){0.0, 0.0, 2.5}); // all around is near
    check_close(axis.distance, 1.5, 1e-15);
    check_close(axis.normal.z, 0.6, 1e-15);
    check_close(hypot(axis.normal.x, axis.normal.y), 0.8, 1e-15);
}

/** A cone in general position; every third ends in a tip. */
static clod_shape random_cone(dice *roll, int number)
{
    clod_shape s = upright(dice_real(roll, 0.0, 2.0), dice_real(roll, 0.0, 2.0),
                           dice_real(roll, 0.3, 3.0), (clod_side)dice_pick(roll, 2));
    if (number % 3 == 0) {
        *(number % 2 == 0 ? &s.outer : &s.inner) = 0.0;
    }
    double turn[3];
    dice_direction(roll, turn);
    const double angle = dice_real(roll, 0.0, 6.0);
    for (int a = 0; a < 3; a++) {
        s.axis[a] = clod_vec3_rotate(s.axis[a], (clod_vec3){turn[0], turn[1], turn[2]}, angle);
    }
    s.center = (clod_vec3){dice_real(roll, -1.0, 1.0), dice_real(roll, -1.0, 1.0),
                           dice_real(roll, -1.0, 1.0)};
    return s;
}

/** The point of the shell at a share of its length and an angle around its axis. */
static clod_vec3 surface_point(const clod_shape *s, double share, double angle)
{
    const double radius = (1.0 - share) * s->outer + share * s->inner;
    clod_vec3 p = clod_vec3_axpy(s->center, 2.0 * s->half[2] * share, s->axis[2]);
    p = clod_vec3_axpy(p, radius * cos(angle), s->axis[0]);
    return clod_vec3_axpy(p, radius * sin(angle), s->axis[1]);
}

static double away(const clod_shape *s, clod_vec3 p, double share, double angle)
{
    return clod_vec3_length(clod_vec3_sub(p, surface_point(s, share, angle)));
}

/** Share of the nearest point of a straight line of the shell: a distance is convex along it.
 */
static double search_line(const clod_shape *s, clod_vec3 p, double angle)
{
    double low = 0.0, high = 1.0;
    for (int level = 0; level < 60; level++) {
        const double third = (high - low) / 3.0;
        if (away(s, p, low + third, angle) < away(s, p, high - third, angle)) {
            high -= third;
        } else {
            low += third;
        }
    }
    return 0.5 * (low + high);
}

#define ANGLES 16

/** Nearest point of the shell: the best of many lines, and again of denser ones around it. */
static clod_vec3 search(const clod_shape *s, clod_vec3 p)
{
    double angle = 0.0, half = M_PI, nearest = HUGE_VAL;
    for (int level = 0; level < 14; level++) {
        const double middle = angle;
        for (int k = 0; k <= ANGLES; k++) {
            const double here = middle + half * (2.0 * k / ANGLES - 1.0);
            const double distance = away(s, p, search_line(s, p, here), here);
            angle = distance < nearest ? here : angle;
            nearest = fmin(nearest, distance);
        }
        half *= 0.25;
    }
    return surface_point(s, search_line(s, p, angle), angle);
}

/** A point anywhere, or close to the shell, its rims and tips. */
static clod_vec3 random_point(dice *roll, const clod_shape *s, int number)
{
    const double share[] = {0.0, 1.0, dice_real(roll, 0.0, 1.0)};
    const double reach = number % 4 == 3 ? 4.0 : 0.2;
    clod_vec3 p = surface_point(s, share[number % 3], dice_real(roll, -M_PI, M_PI));
    double way[3];
    dice_direction(roll, way);
    return clod_vec3_axpy(p, dice_real(roll, 0.01, reach), (clod_vec3){way[0], way[1], way[2]});
}

static void nearest_of_many_points_is_the_contact_point(void **state)
{
    (void)state;
    dice roll = {8};
    for (int c = 0; c < 30; c++) {
        const clod_shape s = random_cone(&roll, c);
        for (int k = 0; k < 24; k++) {
            const clod_vec3 p = random_point(&roll, &s, k);
            const clod_vec3 found = search(&s, p);
            const clod_vec3 arm = clod_vec3_sub(p, found);
            const clod_gap gap = clod_wall_gap(&s, p);
            check_close(gap.distance, clod_vec3_length(arm), 1e-10);
            check_close(clod_vec3_length(gap.normal), 1.0, 1e-12);
            const clod_vec3 foot = clod_vec3_axpy(p, -gap.distance, gap.normal);
            const clod_vec3 off = clod_vec3_sub(foot, found);
            check_close(clod_vec3_length(off), 0.0, 2e-5); // where the distance is flat
            check_close(clod_wall_gap(&s, foot).distance, 0.0, 1e-12);
        }
    }
}

// A distance never changes faster than the point moves: no jump at rims and tips.
static void distance_is_continuous_everywhere(void **state)
{
    (void)state;
    dice roll = {9};
    for (int k = 0; k < (sanitized() ? 20000 : 200000); k++) {
        const clod_shape s = random_cone(&roll, k);
        const clod_vec3 p = random_point(&roll, &s, k);
        double way[3];
        dice_direction(&roll, way);
        const double length = k % 2 == 0 ? 1e-6 : 0.5;
        const clod_vec3 q = clod_vec3_axpy(p, length, (clod_vec3){way[0], way[1], way[2]});
        const double change = clod_wall_gap(&s, q).distance - clod_wall_gap(&s, p).distance;
        check_at_most(fabs(change), length + 1e-14);
    }
}

// The same radius at both ends is a cylinder, bit for bit; one that widens by w is at most w
// off.
static void cone_becomes_a_cylinder(void **state)
{
    (void)state;
    dice roll = {10};
    for (int k = 0; k < (sanitized() ? 2000 : 20000); k++) {
        clod_shape cone = random_cone(&roll, 1);
        cone.inner = cone.outer;
        clod_shape cylinder = cone;
        cylinder.kind = CLOD_SHAPE_CYLINDER;
        const clod_vec3 p = random_point(&roll, &cone, k);
        const clod_gap expected = clod_wall_gap(&cylinder, p);
        const clod_gap found = clod_wall_gap(&cone, p);
        assert_true(found.distance == expected.distance);
        assert_true(found.normal.x == expected.normal.x &&
                    found.normal.y == expected.normal.y && found.normal.z == expected.normal.z);
        for (double widening = 1e-3; widening > 1e-9; widening *= 0.1) {
            cone.inner = cone.outer + widening;
            check_close(clod_wall_gap(&cone, p).distance, expected.distance,
                        widening * (1.0 + 1e-6));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shell_acts_inside_outside_and_at_its_rims),
        cmocka_unit_test(tip_is_a_point),
        cmocka_unit_test(nearest_of_many_points_is_the_contact_point),
        cmocka_unit_test(distance_is_continuous_everywhere),
        cmocka_unit_test(cone_becomes_a_cylinder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
