// A collision cut into steps: its length against closed forms, what it returns against the real
// step.

#include <math.h>

#include "law/law_cycle.h"
#include "setup/collision.h"
#include "support/scene.h"

/** Mass of a grain of 3 mm radius [kg]. */
#define MASS (2481.3 * 4.1887902047863905 * 27e-9)
#define STIFFNESS 1e5

static clod_law law_of(double exponent, double restitution)
{
    clod_case_contact contact = contact_elastic(exponent, STIFFNESS);
    contact.restitution = restitution;
    return clod_law_make(&contact, &ORE, &ORE);
}

// By hand: hooke half a swing, pi sqrt(m/k); with k2 = 4 k1 the way back takes half as long.
// Hertz: 2.94326 d/v (Landau & Lifshitz, Theory of Elasticity, section 9: 2.94) with v^2 =
// 2 (2/5) k d^2.5/m.
static void length_of_a_collision(void **state)
{
    (void)state;
    clod_law hooke = law_of(1.0, 0.5);
    const double swing = 3.14159265358979 * sqrt(1e-4 / STIFFNESS);
    check_relative(clod_collision_time(&hooke, 1e-3, 1e-4, 1e-5), swing, 1e-12);
    hooke.k2 = 4.0 * hooke.k1;
    check_relative(clod_collision_time(&hooke, 1e-3, 1e-4, 1e-5), 0.75 * swing, 1e-12);
    const clod_law hertz = law_of(1.5, 0.5);
    const double speed = sqrt(0.8 * STIFFNESS * pow(1e-5, 2.5) / 1e-4);
    check_relative(clod_collision_time(&hertz, 1e-3, 1e-4, 1e-5), 2.94326 * 1e-5 / speed, 1e-5);
}

/** Through the real step, the first touch a part of a step before a look. */
static double really(double exponent, double restitution, double steps, double part)
{
    clod_case_contact contact = contact_elastic(exponent, STIFFNESS);
    contact.restitution = restitution;
    const clod_law law = clod_law_make(&contact, &ORE, &ORE);
    const double speed = 0.1;
    const double deep = clod_law_cycle_impact(&law, 1.5e-3, 0.25 * MASS * speed * speed);
    scene s;
    scene_init(&s, clod_collision_time(&law, 1.5e-3, 0.5 * MASS, deep) / steps, &contact);
    const double gap = (3.0 - part) * s.state.dt * speed;
    scene_grain(&s, 0.0, 0.0, 0.0, 3e-3);
    const size_t b = scene_grain(&s, 0.0, 0.0, 6e-3 + gap, 3e-3);
    scene_move(&s, b, 0.0, 0.0, -speed);
    scene_start(&s);
    scene_run(&s, (int)(4.0 * steps) + 10);
    const double v = s.state.grains.velocity[scene_row(&s, 1)][2] -
                     s.state.grains.velocity[scene_row(&s, 0)][2];
    scene_end(&s);
    return v / speed;
}

/** All that the real step returns lies in the range, and the range is no wider than that. */
static void range_is_what_the_step_returns(void **state)
{
    (void)state;
    const double exponents[] = {1.0, 1.5};
    const double wanted[] = {0.2, 0.5, 0.8};
    for (int k = 0; k < 6; k++) {
        const double n = exponents[k / 3], e = wanted[k % 3];
        const clod_law law = law_of(n, e);
        const clod_collision_range range = clod_collision_restitution(&law, 29.0);
        double least = 1.0, most = 0.0;
        for (int p = 0; p < 16 * 8; p++) {
            const int length = p / 16;
            const double steps = 29.0 + (length + 0.5) / 8.0 - 0.5;
            const double got = really(n, e, steps, (p % 16 + 0.5) / 16.0);
            least = fmin(least, got);
            most = fmax(most, got);
        }
        check_close(range.least, least, 1e-6);
        check_close(range.most, most, 1e-6);
    }
}

/** Of first order: ten times the steps, a tenth of the error; restitution 0 ends too. */
static void more_steps_return_what_is_asked_for(void **state)
{
    (void)state;
    const clod_law law = law_of(1.0, 0.5);
    for (double steps = 100.0; steps < 2e4; steps *= 10.0) {
        const clod_collision_range range = clod_collision_restitution(&law, steps);
        assert_true(range.least <= range.most);
        assert_true(range.least > 0.5 * (1.0 - 2.0 / steps) &&
                    range.most < 0.5 * (1.0 + 2.0 / steps));
    }
    const clod_law dead = law_of(1.0, 0.0);
    assert_true(clod_collision_restitution(&dead, 30.0).most < 0.05);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(length_of_a_collision),
        cmocka_unit_test(range_is_what_the_step_returns),
        cmocka_unit_test(more_steps_return_what_is_asked_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
