// The largest stable step of small beds whose oscillations have a closed form, and of one that
// the engine itself steps below and above it.

#include "setup/stability.h"

#include "support/dice.h"
#include "support/scene.h"

#define R 3e-3                                     // m
#define MASS (2481.3 * 4.1887902047863905 * 27e-9) // kg
#define K 1e6                                      // N/m
#define GAP (2.0 * R * (1.0 - 1e-3))               // m between centres
#define ARM (0.5 * GAP)                            // m from centre to contact

/** hooke with everything that a test may want to switch on. */
static clod_case_contact contact_hooke(double restitution, double friction)
{
    clod_case_contact contact = contact_elastic(1.0, K);
    contact.restitution = restitution;
    contact.friction = friction;
    return contact;
}

/** z of docs/theory/damping.md. */
static double damping_ratio(double restitution)
{
    const double l = log(restitution);
    return -l / sqrt(l * l + M_PI * M_PI);
}

/** docs/theory/stability.md: the largest step of one oscillator. */
static double largest_step(double omega, double zeta)
{
    return 2.0 / omega * (sqrt(1.0 + zeta * zeta) - zeta);
}

static clod_stability measure(scene *s)
{
    clod_status status = {0};
    clod_stability found;
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(&s->step, &reader);
    if (!clod_stability_measure(&found, &s->state, &contacts, &s->laws, &status)) {
        fail_msg("%s", status.text);
    }
    return found;
}

static void make_pair(scene *s, const clod_case_contact *contact, double radius)
{
    scene_init(s, 1e-9, contact);
    scene_grain(s, 0.0, 0.0, 0.0, R);
    scene_grain(s, 0.0, 0.0, R + radius - 2.0 * R * 1e-3, radius);
}

/** omega^2 = k/m*: of two unequal grains, whatever they do across. */
static void two_grains_swing_along_the_normal(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_hooke(1.0, 0.0);
    const double masses[] = {MASS, 8.0 * MASS};
    for (int k = 0; k < 2; k++) {
        scene s;
        make_pair(&s, &contact, k == 0 ? R : 2.0 * R);
        scene_start(&s);
        const clod_stability found = measure(&s);
        const double omega = sqrt(K * (1.0 / MASS + 1.0 / masses[k]));
        assert_int_equal(found.contacts, 1);
        check_relative(found.frequency, omega, 1e-6);
        check_relative(found.step, 2.0 / omega, 1e-5);
        scene_end(&s);
    }
}

/** The same of unequal grains, whose arms and inertias differ:
 *  omega^2 = k_t (1/m_i + 1/m_j + a_i^2/I_i + a_j^2/I_j). */
static void unequal_grains_swing_across(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_hooke(1.0, 0.5);
    scene s;
    make_pair(&s, &contact, 2.0 * R);
    scene_start(&s);
    const double arm = ARM + R, inertia = 0.4 * 8.0 * MASS * 4.0 * R * R;
    const double per_mass = 1.0 / MASS + 1.0 / (8.0 * MASS) + ARM * ARM / (0.4 * MASS * R * R) +
                            arm * arm / inertia;
    check_relative(measure(&s).frequency, sqrt(K * per_mass), 1e-6);
    scene_end(&s);
}

/** A slip moves and turns: omega^2 = k_t (2/m + 2 a^2/I), I = 0.4 m R^2; 7/2 of 2 k_t/m. */
static void two_grains_swing_across(void **state)
{
    (void)state;
    const double e = 0.3;
    const clod_case_contact contact = contact_hooke(e, 0.5);
    scene s;
    make_pair(&s, &contact, R);
    scene_start(&s);
    const clod_stability found = measure(&s);
    const double per_mass = 2.0 / MASS + 2.0 * ARM * ARM / (0.4 * MASS * R * R);
    check_relative(found.frequency, sqrt(K * per_mass), 1e-6);
    // gamma_t = 2 z sqrt(m* k_t) on the same mass: zeta = gamma_t/(2 sqrt(k_t m))
    const double zeta = damping_ratio(e) * sqrt(0.5 * MASS * per_mass);
    check_relative(found.step, largest_step(found.frequency, zeta), 2e-5);
    scene_end(&s);
}

/** Rolling turns alone: omega^2 = k_r 2/I, k_r = 2.25 mu_r^2 k R*^2 (epsd), with its dash-pot
 *  2 zeta sqrt(I* k_r), I* = 7/5 m R^2/2 about the contact. */
static void two_grains_swing_by_rolling(void **state)
{
    (void)state;
    clod_case_contact contact = contact_hooke(1.0, 0.0);
    contact.rolling = CLOD_ROLLING_EPSD;
    contact.rolling_friction = 2.0;
    contact.rolling_damping = 0.2;
    scene s;
    make_pair(&s, &contact, R);
    scene_start(&s);
    const clod_stability found = measure(&s);
    const double k_r = 2.25 * 4.0 * K * 0.25 * R * R;
    const double about = 0.2 * MASS * R * R; // I/2
    check_relative(found.frequency, sqrt(k_r / about), 1e-6);
    const double dash_pot = 2.0 * 0.2 * sqrt(0.7 * MASS * R * R * k_r);
    const double zeta = dash_pot / (2.0 * sqrt(k_r * about));
    check_relative(found.step, largest_step(found.frequency, zeta), 2e-5);
    scene_end(&s);
}

/** epsd2 has k_r = k_t R*^2; a grain on a plane: k_t (1/m + a^2/I) against k_r/I = 5/2 k_t/m. The
 *  two share the spin: across, [[k_t, k_t a], [k_t a, k_t a^2 + k_r]] by sqrt(m, I). */
static void a_grain_on_a_plane_slips_and_rolls(void **state)
{
    (void)state;
    clod_case_contact contact = contact_hooke(1.0, 0.5);
    contact.rolling = CLOD_ROLLING_EPSD2;
    contact.rolling_friction = 0.1;
    scene s;
    scene_init(&s, 1e-9, &contact);
    scene_grain(&s, 0.0, 0.0, 0.0, R);
    scene_wall(&s, "floor", shape_floor(-ARM));
    scene_start(&s);
    const double inertia = 0.4 * MASS * R * R;
    const double a = K / MASS, d = (K * ARM * ARM + K * R * R) / inertia;
    const double b = K * ARM / sqrt(MASS * inertia);
    const double root = sqrt(0.25 * (a - d) * (a - d) + b * b);
    check_relative(measure(&s).frequency, sqrt(0.5 * (a + d) + root), 1e-6);
    scene_end(&s);
}

/** N equal grains between two walls: omega = 2 sqrt(k/m) sin(N pi/(2 (N + 1))), and with
 *  dash-pots gamma of every contact zeta = gamma omega/(2 k): stiffness and damping are alike. */
static void a_chain_between_walls_has_its_closed_form(void **state)
{
    (void)state;
    static const int COUNTS[] = {1, 2, 5, 40};
    for (int c = 0; c < 8; c++) {
        const int n = COUNTS[c / 2];
        clod_case_contact contact = contact_hooke(c % 2 == 0 ? 1.0 : 0.4, 0.0);
        clod_case_contact wall = contact;
        scene s;
        scene_init(&s, 1e-9, &contact);
        for (int g = 0; g < n; g++) {
            scene_grain(&s, 0.0, 0.0, GAP * (double)g, R);
        }
        scene_wall(&s, "floor", shape_floor(-ARM));
        scene_wall(&s, "lid",
                   shape_plane((clod_vec3){0.0, 0.0, GAP * (n - 1) + ARM},
                               (clod_vec3){0.0, 0.0, -1.0}));
        s.state.walls.wall[0].material = s.state.walls.wall[1].material = 1;
        // m* is m/2 between grains and m at a wall; the same gamma at both
        if (c % 2 == 1) {
            const double z = damping_ratio(0.4) * sqrt(0.5);
            wall.restitution = exp(-M_PI * z / sqrt(1.0 - z * z));
        }
        scene_law(&s, 0, 1, &wall);
        scene_start(&s);
        const clod_stability found = measure(&s);
        const double omega = 2.0 * sqrt(K / MASS) * sin(0.5 * M_PI * n / (n + 1.0));
        const double gamma = c % 2 == 0 ? 0.0 : 2.0 * damping_ratio(0.4) * sqrt(0.5 * MASS * K);
        assert_int_equal(found.contacts, (size_t)n + 1);
        check_relative(found.frequency, omega, 1e-5);
        check_relative(found.step, largest_step(omega, 0.5 * gamma * omega / K), 3e-5);
        scene_end(&s);
    }
}

/**
 * A periodic cubic lattice. Neighbours against each other in all directions: 4 k + 8 k_t by m; all
 * turning alike about z: four contacts slip by 2 a each, 8 k_t a^2 by I.
 */
static void a_cubic_lattice_has_its_closed_form(void **state)
{
    (void)state;
    static const double RATIOS[] = {0.2, 1.0};
    for (int c = 0; c < 2; c++) {
        clod_case_contact contact = contact_hooke(1.0, 0.5);
        contact.tangential_ratio = RATIOS[c];
        scene s;
        scene_init(&s, 1e-9, &contact);
        for (int g = 0; g < 64; g++) {
            const int layer = g / 16, line = g / 4 % 4;
            scene_grain(&s, GAP * (g % 4), GAP * line, GAP * layer, R);
        }
        for (int a = 0; a < 3; a++) {
            s.state.domain.min[a] = -ARM;
            s.state.domain.max[a] = 4.0 * GAP - ARM;
            s.state.domain.periodic[a] = true;
        }
        scene_start(&s);
        const clod_stability found = measure(&s);
        const double moves = (4.0 + 8.0 * RATIOS[c]) * K / MASS;
        const double turns = 8.0 * RATIOS[c] * K * ARM * ARM / (0.4 * MASS * R * R);
        assert_int_equal(found.contacts, 192);
        check_relative(found.frequency, sqrt(fmax(moves, turns)), 1e-5);
        scene_end(&s);
    }
}

/** The contact unloads with k2: 3/2 k2 sqrt(d) of mepa at once; of luding k1 and what k2 has risen. */
static void plastic_contacts_swing_on_their_unloading_branch(void **state)
{
    (void)state;
    const double d = 2.0 * R * 1e-3;
    clod_case_contact contact = contact_ore();
    contact.friction = 0.0;
    contact.rolling = CLOD_ROLLING_NONE;
    scene s;
    make_pair(&s, &contact, R);
    scene_start(&s);
    check_relative(measure(&s).frequency, sqrt(1.5 * 2.37e9 * sqrt(d) * 2.0 / MASS), 1e-6);
    scene_end(&s);

    contact.law = CLOD_LAW_LUDING;
    contact.exponent = 1.0;
    contact.k1 = K;
    contact.k2 = 5.0 * K;
    contact.k_adh = 0.0;
    contact.plasticity_depth = 0.05;
    make_pair(&s, &contact, R);
    scene_start(&s);
    // k2 rises linearly from k1 at 0 to 5 k1 at d* = 2 phi R*/(1 - k1/k2), here 0.1875 mm
    const double k2 = K + 4.0 * K * d / (2.0 * 0.05 * 0.5 * R / 0.8);
    check_relative(measure(&s).frequency, sqrt(k2 * 2.0 / MASS), 1e-6);
    scene_end(&s);
}

/** Largest distance from rest after many steps, over that of the beginning. */
static double growth_of(double restitution, double of_largest)
{
    const clod_case_contact contact = contact_hooke(restitution, 0.0);
    const double omega = sqrt(2.0 * K / MASS); // two walls
    const double zeta = damping_ratio(restitution) * sqrt(2.0);
    scene s;
    scene_init(&s, of_largest * largest_step(omega, zeta), &contact);
    scene_grain(&s, 0.0, 0.0, 0.0, R);
    scene_wall(&s, "floor", shape_floor(-ARM));
    scene_wall(&s, "lid", shape_plane((clod_vec3){0.0, 0.0, ARM}, (clod_vec3){0.0, 0.0, -1.0}));
    scene_move(&s, 0, 0.0, 0.0, 1e-9 * omega * R); // far from losing a contact
    scene_start(&s);
    check_relative(measure(&s).step, largest_step(omega, zeta), 2e-5);
    double most = 0.0;
    for (int k = 0; k < 1000; k++) {
        scene_run(&s, 1);
        most = k >= 990 ? fmax(most, fabs(s.state.grains.position[0][2])) : most;
    }
    scene_end(&s);
    return most / (1e-9 * R);
}

/** The engine holds an oscillator just below the step of docs/theory/stability.md, and loses it
 *  just above. */
static void the_engine_is_stable_up_to_it(void **state)
{
    (void)state;
    check_at_least(60.0,
                   growth_of(1.0, 0.999)); // near the limit the amplitude is 1/sqrt(1 - h^2/4)
    check_at_least(growth_of(1.0, 1.001), 1e6);
    check_at_least(1e-3, growth_of(0.3, 0.99)); // damped
    check_at_least(growth_of(0.3, 1.01), 10.0);
    check_at_least(1e-3, growth_of(0.05, 0.99));
    check_at_least(growth_of(0.05, 1.01), 10.0);
}

static void nothing_that_swings_has_no_limit(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_hooke(1.0, 0.0);
    scene s;
    scene_init(&s, 1e-9, &contact);
    scene_grain(&s, 0.0, 0.0, 0.0, R);
    scene_grain(&s, 0.0, 0.0, 3.0 * R, R);
    scene_start(&s);
    const clod_stability found = measure(&s);
    assert_int_equal(found.contacts, 0);
    assert_true(found.frequency == 0.0 && isinf(found.step));
    scene_end(&s);
}

/** A heap of ore: the same bits on one thread and on three. */
static void threads_change_no_bit(void **state)
{
    (void)state;
    clod_stability found[2];
    for (int c = 0; c < 2; c++) {
        clod_case_contact contact = contact_ore();
        contact.restitution = 0.3;
        dice d = {.state = 5};
        scene s;
        scene_init(&s, 5e-7, &contact);
        for (int g = 0; g < 120; g++) {
            const double wide = 1.5e-3;
            const int layer = g / 16, line = g / 4 % 4;
            const double x = 8.2e-3 * (g % 4) + dice_real(&d, 0.0, wide);
            const double y = 8.2e-3 * line + dice_real(&d, 0.0, wide);
            scene_grain(&s, x, y, 8.2e-3 * layer, 3e-3 + dice_real(&d, 0.0, 3e-4));
        }
        scene_wall(&s, "floor", shape_floor(-4e-3));
        s.state.gravity[2] = -100.0;
        scene_start_with(&s, (clod_step_options){.threads = c == 0 ? 1 : 3});
        scene_run(&s, 40000);
        found[c] = measure(&s);
        scene_end(&s);
    }
    assert_true(found[0].contacts > 50);
    assert_true(found[0].step == found[1].step && found[0].frequency == found[1].frequency);
    check_at_least(2.0 / found[0].frequency, found[0].step);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_grains_swing_along_the_normal),
        cmocka_unit_test(two_grains_swing_across),
        cmocka_unit_test(unequal_grains_swing_across),
        cmocka_unit_test(two_grains_swing_by_rolling),
        cmocka_unit_test(a_grain_on_a_plane_slips_and_rolls),
        cmocka_unit_test(a_chain_between_walls_has_its_closed_form),
        cmocka_unit_test(a_cubic_lattice_has_its_closed_form),
        cmocka_unit_test(plastic_contacts_swing_on_their_unloading_branch),
        cmocka_unit_test(the_engine_is_stable_up_to_it),
        cmocka_unit_test(nothing_that_swings_has_no_limit),
        cmocka_unit_test(threads_change_no_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
