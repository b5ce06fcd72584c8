// Walls that oscillate, in the step: the force they carry in closed form, and their work.

#include "support/scene.h"

#define R 3e-3
#define G 9.81
#define MASS (2481.3 * 4.1887902047863905 * 27e-9)
#define K 2e4

/**
 * A grain that stays on a shaking floor is accelerated with it: F = m (g - a w^2 sin(w t + p)
 * / (1 - (w/w0)^2)), w0 of its contact. Starts at the turning point, where the floor rests.
 */
static void a_shaking_floor_carries_its_grain(void **state)
{
    (void)state;
    clod_case_contact contact = contact_elastic(1.0, K);
    contact.restitution = 0.3;
    scene s;
    scene_init(&s, 1e-6, &contact);
    s.state.gravity[2] = -G;
    clod_wall *floor = scene_wall(&s, "floor", shape_floor(0.0));
    const double w = 2.0 * M_PI * 50.0;
    const double a = 0.5 * G / (w * w);
    floor->oscillation = (clod_oscillation){
        .direction = {0.0, 0.0, 1.0}, .amplitude = a, .frequency = 50.0, .phase = 0.5 * M_PI};
    clod_wall_start(floor);
    scene_grain(&s, 0.0, 0.0, a + R - 0.5 * MASS * G / K, R);
    scene_start(&s);
    scene_run(&s, 20000); // a period
    const double gain = 1.0 / (1.0 - w * w * MASS / K);
    for (int k = 0; k < 200; k++) {
        scene_run(&s, 100);
        const double t = (double)s.state.step * 1e-6;
        check_close(floor->shift.z, a * sin(w * t + 0.5 * M_PI), 1e-15);
        const double expected = -MASS * (G - gain * a * w * w * sin(w * t + 0.5 * M_PI));
        check_close(floor->force.z, expected, 1e-4 * MASS * G);
    }
    scene_end(&s);
}

/** Elastic: what floor and bar do to a grain over many hits is the energy that it has won. */
static void work_of_an_oscillating_wall_is_the_energy_won(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_elastic(1.0, K);
    scene s;
    scene_init(&s, 2e-7, &contact);
    s.state.gravity[2] = -G;
    clod_wall *floor = scene_wall(&s, "floor", shape_floor(0.0));
    floor->oscillation = (clod_oscillation){
        .direction = {0.0, 0.0, 1.0}, .amplitude = 1e-3, .frequency = 60.0, .phase = -0.4};
    clod_wall *bar =
        scene_wall(&s, "bar", shape_box((clod_vec3){0.03, 0.0, 0.045}, 0.03, 0.01, 0.01));
    bar->spin_axis = (clod_vec3){0.0, 1.0, 0.0};
    bar->spin_point.z = 0.045;
    bar->oscillation = (clod_oscillation){.angle = 0.03, .frequency = 45.0};
    clod_wall_start(floor);
    clod_wall_start(bar);
    const size_t row = scene_grain(&s, 0.03, 0.0, 0.02, R);
    scene_start(&s);
    double hits[2] = {0.0, 0.0};
    const double *x = s.state.grains.position[row];
    const double *v = s.state.grains.velocity[row];
    const double start = MASS * G * x[2];
    for (int k = 0; k < 5000; k++) {
        scene_run(&s, 200);
        hits[0] += floor->force.z != 0.0;
        hits[1] += bar->force.z != 0.0;
    }
    while (floor->force.z != 0.0 || bar->force.z != 0.0) { // nothing left in a contact
        scene_run(&s, 1);
    }
    assert_true(hits[0] > 5.0 && hits[1] > 5.0);
    const double *w = s.state.grains.angular_velocity[row];
    const double kinetic = 0.5 * MASS * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) +
                           0.5 * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]) / w[3];
    const double won = kinetic + MASS * G * x[2] - start;
    const double work = 2e-7 * (floor->sum_power + bar->sum_power);
    const double moved = 2e-7 * (fabs(floor->sum_power) + fabs(bar->sum_power));
    assert_true(fabs(floor->sum_power) > 0.0 && fabs(bar->sum_power) > 0.0);
    check_close(work, won, 2e-3 * moved);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_shaking_floor_carries_its_grain),
        cmocka_unit_test(work_of_an_oscillating_wall_is_the_energy_won),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
