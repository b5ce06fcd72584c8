// Motion without contact and the bookkeeping of free bodies: parabola, spin, momentum.

#include "support/dice.h"
#include "support/scene.h"

/** Velocity Verlet is exact for a constant force: only rounding is left. */
static void a_thrown_grain_follows_the_parabola(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_ore();
    scene s;
    scene_init(&s, 1e-4, &contact);
    memcpy(s.state.gravity, (double[3]){0.5, -1.0, -9.81}, sizeof s.state.gravity);
    const size_t g = scene_grain(&s, 0.1, -0.2, 0.3, 3e-3);
    scene_move(&s, g, 1.0, 2.0, 4.0);
    scene_turn(&s, g, 10.0, -20.0, 30.0);
    scene_start(&s);
    scene_run(&s, 10000);
    const double t = 1.0;
    const double *p = s.state.grains.position[0];
    const double *v = s.state.grains.velocity[0];
    check_close(p[0], 0.1 + 1.0 * t + 0.25 * t * t, 1e-11);
    check_close(p[1], -0.2 + 2.0 * t - 0.5 * t * t, 1e-11);
    check_close(p[2], 0.3 + 4.0 * t - 4.905 * t * t, 1e-11);
    check_close(v[0], 1.5, 1e-11);
    check_close(v[1], 1.0, 1e-11);
    check_close(v[2], 4.0 - 9.81, 1e-11);
    const double *w = s.state.grains.angular_velocity[0];
    assert_true(w[0] == 10.0 && w[1] == -20.0 && w[2] == 30.0); // exactly: nothing turns it
    check_close(p[3], 3e-3, 0.0);
    assert_int_equal(s.state.step, 10000);
    check_close(s.state.time, 1.0, 1e-15);
    scene_end(&s);
}

/** Mass and inertia of a solid sphere: 4/3 pi rho R^3, 2/5 m R^2. */
static void a_grain_has_the_inertia_of_a_solid_sphere(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_ore();
    scene s;
    scene_init(&s, 1e-4, &contact);
    scene_grain(&s, 0.0, 0.0, 0.0, 3e-3);
    const double mass = 2481.3 * 4.1887902047863905 * 27e-9;
    check_relative(s.state.grains.velocity[0][3], mass, 1e-14);
    check_relative(s.state.grains.angular_velocity[0][3], 2.5 / (mass * 9e-6), 1e-14);
    clod_state_fini(&s.state);
}

typedef struct balance {
    double momentum[3], angular[3];
    double size; ///< sum of |x| |p| + I |w|, for the tolerance
} balance;

static balance balance_of(const clod_state *state)
{
    balance b = {{0.0}, {0.0}, 0.0};
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *x = state->grains.position[g];
        const double *v = state->grains.velocity[g];
        const double *w = state->grains.angular_velocity[g];
        for (int c = 0; c < 3; c++) {
            const int d = (c + 1) % 3;
            const int e = (c + 2) % 3;
            b.momentum[c] += v[3] * v[c];
            b.angular[c] += v[3] * (x[d] * v[e] - x[e] * v[d]) + w[c] / w[3];
            b.size += fabs(v[3] * v[c]) * 0.03 + fabs(w[c] / w[3]);
        }
    }
    return b;
}

/** A cloud that falls together: damping, friction, rolling, adhesion, several laws. */
static void a_free_cluster_keeps_its_momenta(void **state)
{
    (void)state;
    dice roll = {21};
    for (int rolling = 0; rolling < 4; rolling++) {
        clod_case_contact contact = contact_ore();
        contact.restitution = 0.5;
        contact.rolling = rolling;
        scene s;
        scene_init(&s, 1e-6, &contact);
        contact.law = CLOD_LAW_HERTZ;
        scene_law(&s, 0, 1, &contact);
        for (int k = 0; k < 64; k++) {
            const double a = 0.0075;
            const size_t g = scene_grain(&s, a * (k % 4), a * (k / 4 % 4), a * (k / 16),
                                         dice_real(&roll, 2.7e-3, 3.7e-3));
            double *x = s.state.grains.position[g];
            scene_move(&s, g, -20.0 * (x[0] - 0.011) + dice_real(&roll, -0.1, 0.1),
                       -20.0 * (x[1] - 0.011) + dice_real(&roll, -0.1, 0.1),
                       -20.0 * (x[2] - 0.011) + dice_real(&roll, -0.1, 0.1));
            scene_turn(&s, g, dice_real(&roll, -50.0, 50.0), dice_real(&roll, -50.0, 50.0),
                       dice_real(&roll, -50.0, 50.0));
            s.state.grains.material[g] = (uint16_t)(k % 2);
        }
        scene_start(&s);
        const balance before = balance_of(&s.state);
        scene_run(&s, 8000);
        assert_true(clod_step_export(&s.step, &s.step.status));
        assert_true(s.state.contact_count > 20 && s.step.rebuilds > 1); // they have met
        const balance after = balance_of(&s.state);
        for (int c = 0; c < 3; c++) {
            check_close(after.momentum[c], before.momentum[c], 1e-12 * before.size / 0.03);
            check_close(after.angular[c], before.angular[c], 1e-12 * before.size);
        }
        scene_end(&s);
    }
}

/** A pair across a periodic face touches as it would anywhere, and comes out wrapped. */
static void periodic_images_touch(void **state)
{
    (void)state;
    for (int axis = 0; axis < 3; axis++) {
        double force[2], place[2];
        for (int shifted = 0; shifted < 2; shifted++) {
            const clod_case_contact contact = contact_ore();
            scene s;
            scene_init(&s, 1e-6, &contact);
            for (int a = 0; a < 3; a++) {
                s.state.domain.min[a] = -0.02;
                s.state.domain.max[a] = 0.03;
                s.state.domain.periodic[a] = true;
            }
            double one[3] = {0.001, 0.002, 0.003}, two[3] = {0.001, 0.002, 0.003};
            one[axis] = shifted ? -0.018 : 0.001;
            two[axis] = one[axis] - 0.005999 + (shifted ? 0.05 : 0.0);
            scene_grain(&s, one[0], one[1], one[2], 3e-3);
            scene_grain(&s, two[0], two[1], two[2], 3e-3);
            scene_start(&s);
            force[shifted] = s.state.grains.load[scene_row(&s, 0)][axis];
            scene_run(&s, 20000);
            for (size_t g = 0; g < 2; g++) {
                for (int a = 0; a < 3; a++) {
                    // wrapped at the last rebuild; between two only the skin's motion is added
                    check_at_least(s.state.grains.position[g][a], -0.02 - 1e-3);
                    check_at_most(s.state.grains.position[g][a], 0.03 + 1e-3);
                }
            }
            const double moved = s.state.grains.position[scene_row(&s, 0)][axis] - one[axis];
            place[shifted] = moved - 0.05 * nearbyint(moved / 0.05);
            assert_true(fabs(place[shifted]) > 0.0);
            scene_end(&s);
        }
        check_relative(force[1], force[0], 1e-9);
        assert_true(force[0] > 0.1); // k1 (1e-6)^1.5 = 0.475 N
        check_close(place[1], place[0], 1e-9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_thrown_grain_follows_the_parabola),
        cmocka_unit_test(a_grain_has_the_inertia_of_a_solid_sphere),
        cmocka_unit_test(a_free_cluster_keeps_its_momenta),
        cmocka_unit_test(periodic_images_touch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
