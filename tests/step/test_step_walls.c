// Walls in the step: force, torque and power against momentum and energy; belt, bar, servo.

#include "support/bed.h"

#define R 3e-3
#define G 9.81
#define MASS (2481.3 * 4.1887902047863905 * 27e-9)
#define K 2e4

/** A grain at rest off the axis: its weight on the floor, the moment about the origin. */
static void a_resting_grain_weighs_on_the_floor(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_elastic(1.0, K);
    scene s;
    scene_init(&s, 1e-5, &contact);
    s.state.gravity[2] = -G;
    const clod_wall *floor = scene_wall(&s, "floor", shape_floor(0.0));
    scene_grain(&s, 0.05, 0.02, R - MASS * G / K, R);
    scene_start(&s);
    check_relative(floor->force.z, -MASS * G, 1e-9); // known before the first step
    scene_run(&s, 1000);
    check_relative(floor->force.z, -MASS * G, 1e-9);
    check_close(floor->force.x, 0.0, 1e-18);
    check_relative(floor->torque.x, -0.02 * MASS * G, 1e-9); // r x F
    check_relative(floor->torque.y, 0.05 * MASS * G, 1e-9);
    check_close(floor->power, 0.0, 0.0);
    assert_int_equal(floor->sum_steps, 1000);
    check_relative(floor->sum_force.z, -1000.0 * MASS * G, 1e-9);
    scene_end(&s);
}

/** Lanes without a contact stay so where a wall has all the room about the origin. */
static void a_wall_that_holds_the_origin_touches_its_grain_only(void **state)
{
    (void)state;
    static const char *const SETS[] = {"scalar", "avx2", "avx512", "neon"};
    const clod_case_contact contact = contact_elastic(1.0, K);
    const clod_shape shapes[] = {shape_floor(5.0),
                                 shape_box((clod_vec3){0.0, 0.0, 2.0}, 3.0, 3.0, 3.0)};
    for (int k = 0; k < 8; k++) {
        const char *set = SETS[k / 2];
        if (clod_kernel_choose(set) == NULL) {
            continue;
        }
        scene s;
        scene_init(&s, 1e-5, &contact);
        s.state.gravity[2] = -G;
        const clod_wall *floor = scene_wall(&s, "floor", shapes[k % 2]);
        scene_grain(&s, 0.05, 0.02, 5.0 + R - MASS * G / K, R);
        scene_start_with(&s, (clod_step_options){.threads = 1, .simd = set});
        scene_run(&s, 100); // an overlap of nothing with the floor would end it
        check_relative(floor->force.z, -MASS * G, 1e-8);
        scene_end(&s);
    }
}

/** Momentum and angular momentum about the origin, kinetic energy. */
typedef struct motion {
    double p[3], l[3], kinetic;
} motion;

static motion motion_of(const clod_grains *g)
{
    motion m = {{0.0}, {0.0}, 0.0};
    for (size_t k = 0; k < g->count; k++) {
        const double *x = g->position[k];
        const double *v = g->velocity[k];
        const double *w = g->angular_velocity[k];
        for (int c = 0; c < 3; c++) {
            const int d = (c + 1) % 3;
            const int e = (c + 2) % 3;
            m.p[c] += v[3] * v[c];
            m.l[c] += v[3] * (x[d] * v[e] - x[e] * v[d]) + w[c] / w[3];
            m.kinetic += 0.5 * (v[3] * v[c] * v[c] + w[c] * w[c] / w[3]);
        }
    }
    return m;
}

/**
 * Drum without gravity: what the walls got is what the grains lost, in force and in torque
 * about the origin (walls that turn about it), step by step and to rounding.
 */
static void action_is_reaction(void **state)
{
    (void)state;
    scene s;
    bed_init(&s, BED_DRUM, 6);
    s.state.gravity[2] = 0.0;
    s.state.walls.wall[2].load = CLOD_LOAD_NONE;
    scene_start(&s);
    scene_run(&s, 1500); // until many touch the walls
    clod_walls_reset_sums(&s.state.walls);
    const motion before = motion_of(&s.state.grains);
    double load[6] = {0.0}; // half kicks at both ends: of the sums before and after
    for (int w = 0; w < 3; w++) {
        const clod_wall *wall = &s.state.walls.wall[w];
        const double now[6] = {wall->force.x,  wall->force.y,  wall->force.z,
                               wall->torque.x, wall->torque.y, wall->torque.z};
        for (int c = 0; c < 6; c++) {
            load[c] += 0.5 * now[c];
        }
    }
    scene_run(&s, 1500);
    const motion after = motion_of(&s.state.grains);
    double size = 0.0;
    for (int w = 0; w < 3; w++) {
        const clod_wall *wall = &s.state.walls.wall[w];
        const double sum[6] = {wall->sum_force.x,  wall->sum_force.y,  wall->sum_force.z,
                               wall->sum_torque.x, wall->sum_torque.y, wall->sum_torque.z};
        const double now[6] = {wall->force.x,  wall->force.y,  wall->force.z,
                               wall->torque.x, wall->torque.y, wall->torque.z};
        for (int c = 0; c < 6; c++) {
            load[c] += sum[c] - 0.5 * now[c];
        }
        size += fabs(sum[2]);
    }
    for (int c = 0; c < 3; c++) {
        check_close(after.p[c] - before.p[c], -load[c] * 1e-6, 1e-11 * size * 1e-6 + 1e-16);
        check_close(after.l[c] - before.l[c], -load[3 + c] * 1e-6, 1e-11 * size * 1e-6 + 1e-17);
    }
    assert_true(size > 100.0);
    scene_end(&s);
}

/** An elastic bar that turns hits a grain: twice its speed, torque = spin, work = energy. */
static void a_rotating_bar_pushes_a_grain(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_elastic(1.5, 1e8);
    scene s;
    scene_init(&s, 1e-7, &contact);
    clod_wall *bar =
        scene_wall(&s, "bar", shape_box((clod_vec3){0.05, 0.0, 0.0}, 0.03, 0.002, 0.01));
    bar->spin = 10.0;
    scene_grain(&s, 0.06, 0.002 + R + 1e-4, 0.0, R);
    scene_start(&s);
    scene_run(&s, 20000);
    const motion m = motion_of(&s.state.grains);
    const double speed = sqrt(2.0 * m.kinetic / MASS);
    check_relative(speed, 2.0 * 10.0 * 0.06, 5e-3); // elastic, by a wall that does not yield
    check_close(bar->force.y, 0.0, 0.0);            // it has left
    check_relative(-bar->sum_torque.z * 1e-7, m.l[2], 1e-9);
    check_relative(-bar->sum_force.y * 1e-7, m.p[1], 1e-9);
    check_relative(bar->sum_power * 1e-7, m.kinetic, 1e-4);
    check_relative(bar->sum_power, -10.0 * bar->sum_torque.z, 1e-12); // power = torque x spin
    scene_end(&s);
}

/** The wall turns about its own point, which moves with it. */
static void torque_is_about_the_spin_point(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_elastic(1.0, K);
    scene s;
    scene_init(&s, 1e-6, &contact);
    clod_wall *wall = scene_wall(&s, "plate", shape_floor(0.0));
    wall->spin_point = (clod_vec3){0.01, 0.0, 0.0};
    wall->velocity = (clod_vec3){0.2, 0.0, 0.0};
    scene_grain(&s, 0.05, 0.0, R - 1e-5, R); // pressed by 0.2 N, without friction
    scene_start(&s);
    check_relative(wall->force.z, -0.2, 1e-9);
    check_relative(wall->torque.y, 0.04 * 0.2, 1e-9); // (x - 0.01) 0.2 N
    scene_run(&s, 1);
    check_relative(wall->torque.y / wall->force.z, -(0.04 - 2e-7), 1e-6);
    scene_end(&s);
}

/**
 * Dropped on a belt: v(1 + m R^2/I) = v_belt without rolling friction, so 2/7 of the belt; with
 * it the grain ends at rest on the belt.
 */
static void a_belt_carries_grains(void **state)
{
    (void)state;
    for (int rolling = 0; rolling < 2; rolling++) {
        clod_case_contact contact = contact_elastic(1.0, K);
        contact.restitution = 0.3;
        contact.friction = 0.5;
        contact.rolling = rolling == 0 ? CLOD_ROLLING_NONE : CLOD_ROLLING_EPSD;
        contact.rolling_friction = 0.3;
        contact.rolling_damping = 0.3;
        scene s;
        scene_init(&s, 1e-5, &contact);
        s.state.gravity[2] = -G;
        clod_wall *belt = scene_wall(&s, "belt", shape_floor(0.0));
        belt->surface_velocity = (clod_vec3){0.7, 0.0, 0.0};
        scene_grain(&s, 0.0, 0.0, R - MASS * G / K, R);
        scene_start(&s);
        scene_run(&s, 2000);
        // sliding: friction mu m g on the grain, power F v from the belt
        check_relative(belt->force.x, -0.5 * MASS * G, 1e-3);
        check_relative(belt->power, 0.7 * 0.5 * MASS * G, 1e-3);
        scene_run(&s, 58000);
        const double expected = rolling == 0 ? 0.2 : 0.7;
        check_relative(s.state.grains.velocity[0][0], expected, 1e-3);
        check_close(belt->shift.x, 0.0, 0.0); // the belt itself stays where it is
        scene_end(&s);
    }
}

/** A turning disc speeds a grain up about its axis; its work covers at least the energy. */
static void a_turning_disc_drags_a_grain(void **state)
{
    (void)state;
    clod_case_contact contact = contact_elastic(1.0, K);
    contact.friction = 0.3;
    contact.restitution = 0.5;
    scene s;
    scene_init(&s, 1e-5, &contact);
    s.state.gravity[2] = -G;
    clod_wall *disc = scene_wall(&s, "disc", shape_floor(0.0));
    disc->spin = 4.0;
    scene_grain(&s, 0.1, 0.0, R - MASS * G / K, R);
    scene_start(&s);
    scene_run(&s, 2000);
    const motion m = motion_of(&s.state.grains);
    check_relative(m.p[1], MASS * 0.3 * G * 0.02, 0.01); // mu g t, disc is faster (0.4 m/s)
    check_at_least(disc->sum_power * 1e-5, m.kinetic);
    check_relative(disc->sum_power, -4.0 * disc->sum_torque.z, 1e-12);
    // slipping: the disc's power is mu m g times its speed at the contact
    check_relative(disc->sum_power / 2000.0, 0.3 * MASS * G * 4.0 * 0.1, 0.01);
    scene_end(&s);
}

/** A loaded lid on a column of three grains comes to rest at its load. */
static void a_servo_settles_at_its_load(void **state)
{
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        clod_case_contact contact = contact_elastic(1.5, 1e8);
        contact.restitution = 0.3;
        scene s;
        scene_init(&s, 2e-6, &contact);
        s.state.gravity[2] = -G;
        const clod_wall *floor = scene_wall(&s, "floor", shape_floor(0.0));
        clod_wall *lid = scene_wall(
            &s, "lid",
            shape_plane((clod_vec3){0.0, 0.0, 6.0 * R + 1e-4}, (clod_vec3){0.0, 0.0, -1.0}));
        lid->load = kind == 0 ? CLOD_LOAD_FORCE : CLOD_LOAD_STRESS;
        lid->load_force = 5.0;
        lid->load_axis = (clod_vec3){0.0, 0.0, -1.0};
        lid->mass = 0.01;
        lid->damping = 20.0;
        for (int k = 0; k < 3; k++) {
            scene_grain(&s, 0.0, 0.0, R * (2 * k + 1), R);
        }
        scene_start(&s);
        scene_run(&s, 40000);
        check_relative(lid->force.z, 5.0, 1e-6);
        check_relative(floor->force.z, -(5.0 + 3.0 * MASS * G), 1e-6);
        check_close(lid->servo_velocity, 0.0, 1e-7);
        // four contacts of (5 N/1e8)^(2/3) each, floor to lid
        check_close(lid->shift.z, -1e-4 - 4.0 * pow(5.0 / 1e8, 2.0 / 3.0), 1e-6);
        lid->load_force = 2.0; // a new load is followed
        scene_run(&s, 40000);
        check_relative(lid->force.z, 2.0, 1e-6);
        scene_end(&s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_resting_grain_weighs_on_the_floor),
        cmocka_unit_test(a_wall_that_holds_the_origin_touches_its_grain_only),
        cmocka_unit_test(action_is_reaction),
        cmocka_unit_test(a_rotating_bar_pushes_a_grain),
        cmocka_unit_test(torque_is_about_the_spin_point),
        cmocka_unit_test(a_belt_carries_grains),
        cmocka_unit_test(a_turning_disc_drags_a_grain),
        cmocka_unit_test(a_servo_settles_at_its_load),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
