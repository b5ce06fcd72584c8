// Grains in cones: rest by the balance of forces, energy and angular momentum of bouncing, and
// the way over the rim that a cone shares with a cylinder.

#include "support/scene.h"

#define R 3e-3
#define G 9.81
#define MASS (2481.3 * 4.1887902047863905 * 27e-9)
#define K 2e4
#define DT 1e-6

/** Gravity at right angles to the shell at (25, 0, 20) mm, by the triangle 3, 4, 5. */
static void a_grain_rests_on_a_cone(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_elastic(1.0, K);
    const double weight = MASS * G;
    const double off = R - weight / K;
    scene s;
    scene_init(&s, DT, &contact);
    s.state.gravity[0] = 0.8 * G;
    s.state.gravity[2] = -0.6 * G;
    const clod_wall *wall = scene_wall(&s, "cone", shape_hopper(0.0, 0.01, 0.04, 0.04));
    scene_grain(&s, 0.025 - 0.8 * off, 0.0, 0.02 + 0.6 * off, R);
    scene_start(&s);
    scene_run(&s, 5000);
    check_relative(wall->force.x, 0.8 * weight, 1e-8);
    check_relative(wall->force.z, -0.6 * weight, 1e-8);
    check_close(wall->force.y, 0.0, 1e-15);
    check_relative(wall->torque.y, (0.02 * 0.8 + 0.025 * 0.6) * weight, 1e-8); // r x F
    check_close(s.state.grains.position[0][0], 0.025 - 0.8 * off, 1e-13);
    scene_end(&s);
}

/**
 * A grain deep in a tip is carried by one contact, now on one side and then on the other: on
 * average its weight, F 0.6 = m g, at the height (R - F/K)/0.6 above the tip.
 */
static void a_grain_rests_in_the_tip(void **state)
{
    (void)state;
    clod_case_contact contact = contact_elastic(1.0, K);
    contact.restitution = 0.3;
    scene s;
    scene_init(&s, DT, &contact);
    s.state.gravity[2] = -G;
    clod_wall *wall = scene_wall(&s, "cone", shape_hopper(0.0, 0.0, 0.03, 0.04));
    const double height = (R - MASS * G / 0.6 / K) / 0.6;
    scene_grain(&s, 2e-6, 1e-6, height + 1e-5, R);
    scene_start(&s);
    scene_run(&s, 200000);
    clod_walls_reset_sums(&s.state.walls);
    scene_run(&s, 100000);
    check_relative(wall->sum_force.z / 1e5, -MASS * G, 1e-5);
    check_close(wall->sum_force.x / 1e5, 0.0, 1e-3 * MASS * G);
    check_close(s.state.grains.position[0][2], height, 1e-3 * R);
    check_close(hypot(s.state.grains.position[0][0], s.state.grains.position[0][1]), 0.0,
                1e-3 * R);
    scene_end(&s);
}

static double energy(const clod_state *state)
{
    const double *x = state->grains.position[0];
    const double *v = state->grains.velocity[0];
    const double *g = state->gravity;
    return MASS * (0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) -
                   (g[0] * x[0] + g[1] * x[1] + g[2] * x[2]));
}

static double angular_momentum(const clod_state *state)
{
    const double *x = state->grains.position[0];
    const double *v = state->grains.velocity[0];
    return x[0] * v[1] - x[1] * v[0];
}

/** Elastic and smooth: energy stays, and as normals meet the axis, so does what turns about it.
 */
static void a_bouncing_grain_keeps_its_energy(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_elastic(1.0, K);
    scene s;
    scene_init(&s, DT, &contact);
    s.state.gravity[2] = -G;
    const clod_wall *wall = scene_wall(&s, "cone", shape_hopper(0.0, 0.0, 0.04, 0.05));
    const size_t row = scene_grain(&s, 0.012, 0.004, 0.035, R);
    scene_move(&s, row, 0.1, -0.25, 0.0);
    scene_start(&s);
    const double e0 = energy(&s.state);
    const double l0 = angular_momentum(&s.state);
    int bounces = 0;
    bool touched = false;
    for (int k = 0; k < 800000; k++) {
        scene_run(&s, 1);
        const bool touches = wall->force.z != 0.0;
        bounces += touches && !touched;
        touched = touches;
        if (!touches) {
            check_relative(energy(&s.state), e0, 1e-4);
        }
        check_relative(angular_momentum(&s.state), l0, 1e-9);
    }
    assert_true(bounces >= 10);
    scene_end(&s);
}

/** Two shells that share a rim: of two walls, or of one. */
typedef struct junction {
    clod_shape upper, lower;
    double gravity[3];
    double start[3];
    double speed[3];
    int64_t steps;
} junction;

static void start_junction(scene *s, const junction *from, bool one_wall)
{
    const clod_case_contact contact = contact_elastic(1.0, K);
    scene_init(s, DT, &contact);
    memcpy(s->state.gravity, from->gravity, sizeof from->gravity);
    clod_wall *wall = scene_wall(s, "upper", from->upper);
    if (one_wall) {
        wall->shape_count = 2;
        wall->shapes = clod_memory_grow(wall->shapes, 1, 2, sizeof *wall->shapes);
        wall->shapes[1] = from->lower;
    } else {
        scene_wall(s, "lower", from->lower);
    }
    const size_t row = scene_grain(s, from->start[0], from->start[1], from->start[2], R);
    scene_move(s, row, from->speed[0], from->speed[1], from->speed[2]);
    scene_start(s);
}

/** Force of the upper and of the lower shell over the way of the grain. */
typedef struct passage {
    double largest;  ///< N, of the sum
    double together; ///< N, largest force that both have at a time at least
    double jump;     ///< largest change in one step over what two springs can change
} passage;

/**
 * Run two walls and one wall side by side. A distance changes at most by the way of the grain,
 * so the force of each shell by K times the way, and by its turning about the contact point.
 */
static passage pass(const junction *from)
{
    scene two, one;
    passage seen = {0.0, 0.0, 0.0};
    start_junction(&two, from, false);
    start_junction(&one, from, true);
    const clod_wall *wall = two.state.walls.wall;
    const double e0 = energy(&two.state);
    clod_vec3 before = clod_vec3_add(wall[0].force, wall[1].force);
    for (int64_t k = 0; k < from->steps; k++) {
        const double *v = two.state.grains.velocity[0];
        const double way = DT * (sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + G * DT);
        scene_run(&two, 1);
        scene_run(&one, 1);
        const clod_vec3 now = clod_vec3_add(wall[0].force, wall[1].force);
        const double change = clod_vec3_length(clod_vec3_sub(now, before));
        const double force = clod_vec3_length(now);
        const double most = 2.0 * K * way + force * way / (0.9 * R);
        const double a = clod_vec3_length(wall[0].force);
        const double b = clod_vec3_length(wall[1].force);
        seen.jump = fmax(seen.jump, change / most);
        seen.largest = fmax(seen.largest, force);
        seen.together = fmax(seen.together, fmin(a, b));
        before = now;
        assert_memory_equal(two.state.grains.position[0], one.state.grains.position[0], 32);
        assert_memory_equal(two.state.grains.velocity[0], one.state.grains.velocity[0], 32);
    }
    const double stored = seen.largest * seen.largest / K; // at most, in the springs
    check_close(energy(&two.state), e0, stored);
    scene_end(&two);
    scene_end(&one);
    return seen;
}

// A hopper: down a cylinder and into the corner with a cone that closes. The grain has one
// contact with each there, in two directions.
static void the_force_is_continuous_into_a_hopper(void **state)
{
    (void)state;
    const junction hopper = {.upper = shape_drum(0.0, 0.03, 0.05),
                             .lower = shape_hopper(-0.03, 0.0075, 0.03, 0.03),
                             .gravity = {0.5 * G, 0.0, -0.8 * G},
                             .start = {0.03 - R + 0.5 * MASS * G / K, 0.0, 0.004},
                             .speed = {0.0, 0.0, 0.0},
                             .steps = 60000};
    const passage seen = pass(&hopper);
    check_at_most(seen.jump, 1.0);
    check_at_least(seen.together, 0.2 * MASS * G); // it was in the corner
    check_at_least(seen.largest, 0.9 * MASS * G);  // and has left it along the cone
}

/**
 * The outlet of a hopper: down a cone (0.6, 0.8) and over its foot into a tube. At the rim both
 * shells have their closest point in the same place and carry half of the load each: the grain
 * stands half an overlap further out, and no force jumps. Gravity is such that the grain slides
 * down the cone and is never so fast on the rim that it leaves it.
 */
static void the_force_is_continuous_over_a_rim(void **state)
{
    (void)state;
    const double normal = 0.74 * 0.8 + 0.673 * 0.6; // of gravity, out of the cone
    const double off = R - normal * MASS * G / K;
    const double up = 0.5e-3; // along the cone, above the rim
    const junction outlet = {.upper = shape_hopper(0.0, 0.012, 0.042, 0.04),
                             .lower = shape_drum(-0.05, 0.012, 0.05),
                             .gravity = {0.74 * G, 0.0, -0.673 * G},
                             .start = {0.012 + 0.6 * up - 0.8 * off, 0.0, 0.8 * up + 0.6 * off},
                             .speed = {0.0, 0.0, 0.0},
                             .steps = 70000};
    const passage seen = pass(&outlet);
    check_at_most(seen.jump, 1.0);
    check_at_least(seen.together, 0.3 * MASS * G); // half of what presses
    check_at_most(seen.largest, 1.6 * MASS * G);   // not twice
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_grain_rests_on_a_cone),
        cmocka_unit_test(a_grain_rests_in_the_tip),
        cmocka_unit_test(a_bouncing_grain_keeps_its_energy),
        cmocka_unit_test(the_force_is_continuous_into_a_hopper),
        cmocka_unit_test(the_force_is_continuous_over_a_rim),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
