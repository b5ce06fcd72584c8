// The closed forms that the suite expects, against integrals summed here and numbers by hand.

#include "support/check.h"
#include "verify/chung_ooi.h"
#include "verify/luding.h"
#include "verify/rebound.h"

static const clod_verify_chung_material BALL = {"ball", 3.0 / (4.0 * M_PI), 1e9, 0.0};

/** Sphere of mass 1 kg and radius 1 m on a plane with E* = 1 GPa, at 1 m/s. */
static clod_verify_chung on_plane(double restitution, double friction)
{
    return (clod_verify_chung){
        .a = &BALL, .radius_a = 1.0, .restitution = restitution, .friction = friction};
}

/** Time and force-weighted overlap of m d'' = -k d^1.5, in small steps. */
static void integrate(double m, double k, double v, double found[3])
{
    const double dt = 1e-7;
    double d = 0.0;
    double impulse = 0.0;
    double weighted = 0.0;
    found[0] = 0.0;
    found[2] = 0.0;
    do {
        const double middle = fmax(d + 0.5 * dt * v, 0.0);
        const double force = k * middle * sqrt(middle);
        v -= dt * force / m;
        d = middle + 0.5 * dt * v;
        impulse += force * dt;
        weighted += middle * force * dt;
        found[0] += dt;
        found[2] = fmax(found[2], d);
    } while (d > 0.0);
    found[1] = weighted / impulse;
}

static void hertz_is_what_the_equation_of_motion_gives(void **state)
{
    (void)state;
    const clod_verify_chung chung = on_plane(1.0, 0.0);
    const clod_verify_pair pair = clod_verify_chung_pair(&chung, 1.0);
    check_relative(clod_verify_hertz_mass(&pair), 1.0, 1e-14);
    check_relative(clod_verify_hertz_stiffness(&pair), 4e9 / 3.0, 1e-14);
    double found[3];
    integrate(1.0, 4e9 / 3.0, 1.0, found);
    check_relative(clod_verify_hertz_duration(&pair), found[0], 1e-4);
    check_relative(clod_verify_hertz_mean_overlap(&pair), found[1], 1e-4);
    check_relative(clod_verify_hertz_overlap(&pair), found[2], 1e-4);
    check_relative(clod_verify_hertz_force(&pair), 4e9 / 3.0 * pow(found[2], 1.5), 1e-4);
}

/** Two spheres of 1 and 3 kg (radii 1 and 2 m): m* 3/4, R* 2/3, E* halved. */
static void a_pair_has_reduced_mass_and_radius(void **state)
{
    (void)state;
    const clod_verify_chung_material heavy = {"heavy", 9.0 / (8.0 * 4.0 * M_PI), 1e9, 0.0};
    const clod_verify_chung chung = {
        .a = &BALL, .b = &heavy, .radius_a = 1.0, .radius_b = 2.0, .restitution = 1.0};
    const clod_verify_pair pair = clod_verify_chung_pair(&chung, 1.0);
    check_relative(clod_verify_hertz_mass(&pair), 0.75, 1e-14);
    check_relative(clod_verify_hertz_radius(&pair), 2.0 / 3.0, 1e-14);
    check_relative(pair.young_star, 5e8, 1e-14);
}

/** e = 0.5, mu = 0.2, v_n = 1: change 0.3 along t, 0.75 rad/s; slip threshold 1.05 m/s. */
static void sliding_takes_the_friction_of_the_normal_impulse(void **state)
{
    (void)state;
    const clod_verify_chung chung = on_plane(0.5, 0.2);
    const clod_verify_chung_point fast = {.normal = 1.0, .slip = 2.0};
    const clod_verify_chung_point slow = {.normal = 1.0, .slip = 1.04};
    const clod_verify_chung_point spun = {.normal = 1.0, .spin_a = 2.0};
    assert_true(clod_verify_chung_slides(&chung, &fast));
    assert_false(clod_verify_chung_slides(&chung, &slow));
    const clod_verify_chung_after after = clod_verify_chung_sliding(&chung, &fast);
    check_close(after.v_a, 1.7, 1e-14);
    check_close(after.w_a, 0.75, 1e-14);
    const clod_verify_chung_after spin = clod_verify_chung_sliding(&chung, &spun);
    check_close(spin.v_a, 0.3, 1e-14); // its surface slips along -t, so friction is along +t
    check_close(spin.w_a, 1.25, 1e-14);
}

/** d* 1/32 m, so k2 - k1 = 12800 d_max: 128 N/m at 1 cm, and 1 - 228 (0.01 - d) in newtons. */
static void luding_is_what_its_lines_give(void **state)
{
    (void)state;
    const clod_verify_luding law = {
        .k1 = 100.0, .k2 = 500.0, .k_adh = 100.0, .depth = 0.05, .diameter = 0.5};
    check_relative(clod_verify_luding_limit(&law), 0.03125, 1e-14);
    check_relative(clod_verify_luding_stiffness(&law, 0.01), 228.0, 1e-14);
    check_relative(clod_verify_luding_stiffness(&law, 0.04), 500.0, 1e-14);
    check_relative(clod_verify_luding_elastic(&law, 0.008, 0.01), 0.544, 1e-13);
    check_relative(clod_verify_luding_elastic(&law, 0.05, 0.05), 12.5, 1e-13);
    const double pull = clod_verify_luding_pull(&law, 0.01); // 228 d - 1.28 = -100 d
    check_relative(pull, 1.28 / 328.0, 1e-13);
    check_relative(clod_verify_luding_left(&law, pull), 0.01, 1e-13);
    double most = 0.0;
    check_relative(clod_verify_luding_force(&law, 0.01, &most), 1.0, 1e-13);
    check_relative(clod_verify_luding_force(&law, 0.008, &most), 0.544, 1e-13);
    check_relative(clod_verify_luding_force(&law, 0.003, &most), -0.3, 1e-13);
    check_relative(most, 328.0 / 128.0 * 0.003, 1e-13);
    check_close(clod_verify_luding_force(&law, 0.0, &most), 0.0, 0.0);
    check_close(most, 0.0, 0.0);
}

/** A stiff sphere of 1 kg and 1 m on a plane; overlaps of a thousandth of the radius. */
static clod_verify_rebound rebound_of(double restitution, double friction, double slip)
{
    return (clod_verify_rebound){.radius = 1.0,
                                 .mass = 1.0,
                                 .young_star = 1e9,
                                 .shear_star = 0.4e9,
                                 .restitution = restitution,
                                 .friction = friction,
                                 .normal = 1.0,
                                 .slip = slip};
}

/** Slides throughout: v and R w change by mu (1 + e) v_n and 5/2 of it (hertz.h), but for the
 * lever R - d. */
static void a_fast_rebound_is_that_of_sliding(void **state)
{
    (void)state;
    const clod_verify_rebound one = rebound_of(0.8, 0.2, 5.0);
    const double impulse = 0.2 * 1.8;
    const double v = 5.0 - impulse;
    const double w = 2.5 * impulse;
    check_relative(clod_verify_rebound_energy(&one, 20000), (v * v + 0.4 * w * w) / 25.0, 1e-3);
}

/** Without friction all is left. */
static void a_smooth_rebound_keeps_its_slip(void **state)
{
    (void)state;
    const clod_verify_rebound one = rebound_of(0.8, 0.0, 0.3);
    check_relative(clod_verify_rebound_energy(&one, 1000), 1.0, 1e-12);
}

/** Elastic, without dash-pot, and nearly along the normal: no more than what came, no less than
 * what rolling keeps (5/7, Chung & Ooi); the spring swings in between. Twice the steps, half
 * the error. */
static void a_steep_rebound_makes_no_energy(void **state)
{
    (void)state;
    const clod_verify_rebound one = rebound_of(1.0, 0.5, 0.1);
    const double coarse = clod_verify_rebound_energy(&one, 2000);
    const double fine = clod_verify_rebound_energy(&one, 4000);
    const double finest = clod_verify_rebound_energy(&one, 1000000);
    check_at_most(finest, 1.0);
    check_at_most(5.0 / 7.0, finest);
    check_at_most(fabs(fine - finest), 0.6 * fabs(coarse - finest));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hertz_is_what_the_equation_of_motion_gives),
        cmocka_unit_test(a_pair_has_reduced_mass_and_radius),
        cmocka_unit_test(sliding_takes_the_friction_of_the_normal_impulse),
        cmocka_unit_test(luding_is_what_its_lines_give),
        cmocka_unit_test(a_fast_rebound_is_that_of_sliding),
        cmocka_unit_test(a_smooth_rebound_keeps_its_slip),
        cmocka_unit_test(a_steep_rebound_makes_no_energy),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
