// Surfaces of walls: their own materials, and belts: constant, along a direction of the
// surface, and turning; alone and on a wall that moves. What they do is known in closed form.

#include "geometry/wall_pose.h"
#include "support/bed.h"

#define R 3e-3
#define G 9.81
#define MASS (2481.3 * 4.1887902047863905 * 27e-9)
#define K 2e4
#define DT 1e-5

/** Share of a belt's velocity that a grain without rolling friction ends with: 2/7, but for the
 *  overlap, by which its lever is shorter. */
static double share(void)
{
    const double lever = R - MASS * G / K;
    return 1.0 / (1.0 + lever * lever / (0.4 * R * R));
}

static clod_case_contact rough(double friction)
{
    clod_case_contact contact = contact_elastic(1.0, K);
    contact.restitution = 0.3;
    contact.friction = friction;
    return contact;
}

/** A grain at rest on a floor that is not there yet. */
static void grain_on_floor(scene *s, double x)
{
    const clod_case_contact contact = rough(0.5);
    scene_init(s, DT, &contact);
    s->state.gravity[2] = -G;
    scene_grain(s, x, 0.0, R - MASS * G / K, R);
}

/** Constant, and along a direction that the floor projects: the same belt. */
static void a_belt_carries_a_grain(void **state)
{
    (void)state;
    for (int along = 0; along < 2; along++) {
        scene s;
        grain_on_floor(&s, 0.0);
        clod_wall *wall = scene_wall(&s, "belt", shape_floor(0.0));
        clod_belt *belt = &wall->shapes[0].belt;
        if (along == 0) {
            belt->velocity = (clod_vec3){0.7, 0.0, 0.0};
        } else {
            belt->speed = 0.7;
            belt->direction = clod_vec3_unit((clod_vec3){1.0, 0.0, -2.0});
        }
        scene_start(&s);
        scene_open_ledger(&s);
        scene_run(&s, 2000); // it slides
        check_relative(wall->force.x, -0.5 * MASS * G, 1e-3);
        check_relative(wall->power, 0.7 * 0.5 * MASS * G, 1e-3);
        check_close(wall->power, wall->belt_power, 1e-12);
        scene_run(&s, 58000);
        check_relative(s.state.grains.velocity[0][0], 0.7 * share(), 1e-4);
        check_close(wall->shift.x, 0.0, 0.0);
        const clod_energies now = clod_step_energies(&s.step);
        const double work = s.state.ledger.wall_work;
        check_at_least(work, 0.7 * 0.7 * share() * MASS * 0.99); // v times momentum given
        check_close(clod_ledger_residual(&s.state.ledger, &now), 0.0, 2e-3 * work);
        scene_end(&s);
    }
}

/** What of a belt is normal to the surface moves nothing: the grain lies there. */
static void a_belt_along_the_normal_stands(void **state)
{
    (void)state;
    const clod_belt belts[] = {{.speed = 3.0, .direction = {0.0, 0.0, 1.0}},
                               {.velocity = {0.0, 0.0, 3.0}},
                               {.spin = 30.0,
                                .spin_axis = {0.0, 1.0, 0.0}, // -3 z at 0.1 x
                                .spin_point = {-0.1, 0.0, 0.0}}};
    for (int k = 0; k < 4; k++) {
        scene s;
        grain_on_floor(&s, 0.0);
        clod_wall *wall = scene_wall(&s, "belt", shape_floor(0.0));
        if (k < 3) {
            wall->shapes[0].belt = belts[k];
        } else {
            wall->surface_velocity.z = 3.0;
        }
        scene_start(&s);
        scene_run(&s, 2000);
        check_close(wall->force.x, 0.0, 1e-12);
        check_relative(wall->force.z, -MASS * G, 1e-9);
        check_close(wall->power, 0.0, 1e-12);
        scene_end(&s);
    }
}

/** Rows say what clod_wall_material_velocity says, on a wall that moves in every way. */
static void grains_see_the_velocity_of_the_material(void **state)
{
    (void)state;
    for (int k = 0; k < 20; k++) {
        dice roll = {(uint64_t)k};
        scene s;
        const clod_case_contact contact = contact_elastic(1.0, K); // no friction at all
        scene_init(&s, DT, &contact);
        clod_wall *wall =
            scene_wall(&s, "ball", shape_box((clod_vec3){0.1, 0.2, 0.3}, 0.4, 0.5, 0.6));
        clod_vec3 *any[] = {
            &wall->velocity, &wall->surface_velocity,        &wall->spin_point,
            &wall->shift,    &wall->shapes[0].belt.velocity, &wall->shapes[0].belt.spin_point};
        clod_vec3 *unit[] = {&wall->spin_axis, &wall->shapes[0].belt.direction,
                             &wall->shapes[0].belt.spin_axis};
        for (int v = 0; v < 6; v++) {
            *any[v] = (clod_vec3){dice_real(&roll, -1.0, 1.0), dice_real(&roll, -1.0, 1.0),
                                  dice_real(&roll, -1.0, 1.0)};
        }
        for (int v = 0; v < 3; v++) {
            *unit[v] = clod_vec3_unit(
                (clod_vec3){dice_real(&roll, -1.0, 1.0), dice_real(&roll, -1.0, 1.0), 1.0});
        }
        wall->spin = dice_real(&roll, -5.0, 5.0);
        wall->angle = dice_real(&roll, -3.0, 3.0);
        wall->shapes[0].belt.spin = dice_real(&roll, -5.0, 5.0);
        wall->shapes[0].belt.speed = dice_real(&roll, -1.0, 1.0);
        clod_wall_set_orientation(wall, (clod_quat){dice_real(&roll, -1.0, 1.0),
                                                    dice_real(&roll, -1.0, 1.0),
                                                    dice_real(&roll, -1.0, 1.0), 1.0});
        // a grain on the face along the box's third axis: the power is F v, F along the normal,
        // and the belt has no part in it
        const clod_wall_pose pose = clod_wall_pose_now(wall);
        const clod_vec3 n = clod_wall_to_space(&pose, (clod_vec3){0.0, 0.0, 1.0});
        const clod_vec3 foot = clod_wall_point_to_space(&pose, (clod_vec3){0.2, 0.1, 0.9});
        const clod_vec3 at = clod_vec3_axpy(foot, 0.99 * R, n);
        scene_grain(&s, at.x, at.y, at.z, R);
        scene_start(&s);
        const clod_vec3 v = clod_wall_material_velocity(wall, 0, foot, n);
        const double push = 0.01 * R * K;
        check_relative(wall->power, push * clod_vec3_dot(v, n), 1e-8);
        check_close(wall->belt_power, 0.0, 1e-12);
        check_relative(-clod_vec3_dot(wall->force, n), push, 1e-9);
        scene_end(&s);
    }
}

/**
 * A ball that rolls on a turntable moves on a circle, whose angular velocity is the table's
 * times `share` (2/7): dv/dt = share Omega z x v. The table's turning is that of a wall and
 * that of its belt, about two parallel axes: together about the point between them.
 */
static void a_ball_circles_on_a_turntable(void **state)
{
    (void)state;
    const double wall_spin[] = {0.0, 8.0}, belt_spin[] = {20.0, 12.0};
    const double offset[] = {0.05, 0.0}; // the belt's axis turns with the wall
    const double start = 0.1, speed = 0.2;
    for (int k = 0; k < 2; k++) {
        scene s;
        grain_on_floor(&s, start);
        clod_wall *wall = scene_wall(&s, "table", shape_floor(0.0));
        wall->spin = wall_spin[k];
        wall->shapes[0].belt = (clod_belt){.spin = belt_spin[k],
                                           .spin_axis = {0.0, 0.0, 1.0},
                                           .spin_point = {offset[k], 0.0, 0.7}};
        const double omega = wall_spin[k] + belt_spin[k];
        const double middle = offset[k];
        const double lever = R - MASS * G / K;
        scene_move(&s, 0, 0.0, speed, 0.0);
        scene_turn(&s, 0, (omega * (start - middle) - speed) / lever, 0.0, 0.0); // it rolls
        scene_start(&s);
        const double rate = share() * omega;
        const double radius = speed / rate;
        const int64_t half = (int64_t)(M_PI / rate / DT);
        scene_run(&s, half);
        const double *p = s.state.grains.position[0];
        const double left = M_PI - rate * DT * (double)half; // of the half circle
        check_close(p[0], start - radius * (1.0 + cos(left)), 2e-4 * radius);
        check_close(p[1], radius * sin(left), 2e-4 * radius);
        scene_run(&s, half);
        check_close(p[0], start, 4e-4 * radius);
        check_close(wall->angle, wall_spin[k] * DT * 2.0 * (double)half, 1e-9);
        scene_end(&s);
    }
}

/** Two shapes of one wall with two materials: each has the friction of its own. */
static void shapes_have_their_own_materials(void **state)
{
    (void)state;
    scene s;
    grain_on_floor(&s, 0.0);
    scene_grain(&s, 1.0, 0.0, R - MASS * G / K, R);
    const clod_case_contact smooth = rough(0.1);
    scene_law(&s, 0, 1, &smooth);
    clod_wall *wall =
        scene_wall(&s, "floor", shape_box((clod_vec3){0.0, 0.0, -0.5}, 0.4, 0.4, 0.5));
    clod_memory_free(wall->shapes);
    wall->shape_count = 2;
    wall->shapes = clod_memory_alloc(2, sizeof *wall->shapes);
    wall->shapes[0] = shape_box((clod_vec3){0.0, 0.0, -0.5}, 0.4, 0.4, 0.5);
    wall->shapes[1] = shape_box((clod_vec3){1.0, 0.0, -0.5}, 0.4, 0.4, 0.5);
    wall->shapes[1].material = 1 + 1;
    scene_move(&s, 0, 0.0, 1.0, 0.0);
    scene_move(&s, 1, 0.0, 1.0, 0.0);
    scene_start(&s);
    scene_run(&s, 2000);
    const double time = 2000 * DT;
    check_relative(1.0 - s.state.grains.velocity[scene_row(&s, 0)][1], 0.5 * G * time, 1e-2);
    check_relative(1.0 - s.state.grains.velocity[scene_row(&s, 1)][1], 0.1 * G * time, 1e-2);
    scene_end(&s);
}

/** A belt turns with its wall: on a plate that is tilted by an orientation it runs uphill. */
static void a_belt_turns_with_its_wall(void **state)
{
    (void)state;
    scene s;
    const clod_case_contact contact = rough(0.5);
    scene_init(&s, DT, &contact);
    const double tilt = 0.3;
    const clod_vec3 up = {sin(tilt), 0.0, cos(tilt)}, along = {cos(tilt), 0.0, -sin(tilt)};
    clod_wall *wall =
        scene_wall(&s, "plate", shape_box((clod_vec3){0.0, 0.0, -0.1}, 1.0, 1.0, 0.1));
    wall->shapes[0].belt.velocity = (clod_vec3){0.7, 0.0, 0.0};
    clod_wall_set_orientation(wall, clod_quat_about((clod_vec3){0.0, 1.0, 0.0}, tilt));
    const clod_vec3 at = clod_vec3_scale(up, R - MASS * G / K);
    for (int a = 0; a < 3; a++) {
        s.state.gravity[a] = -G * (a == 0 ? up.x : a == 1 ? up.y : up.z);
    }
    scene_grain(&s, at.x, at.y, at.z, R);
    scene_start(&s);
    scene_run(&s, 60000);
    const double *v = s.state.grains.velocity[0];
    check_close(v[0], 0.7 * share() * along.x, 1e-4);
    check_close(v[2], 0.7 * share() * along.z, 1e-4);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_belt_carries_a_grain),
        cmocka_unit_test(a_belt_along_the_normal_stands),
        cmocka_unit_test(grains_see_the_velocity_of_the_material),
        cmocka_unit_test(a_ball_circles_on_a_turntable),
        cmocka_unit_test(shapes_have_their_own_materials),
        cmocka_unit_test(a_belt_turns_with_its_wall),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
