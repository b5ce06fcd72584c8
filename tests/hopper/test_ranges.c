// Flow functions that cross the flow factor more than once: above the critical outlet no arch stands.

#include "hopper/ranges.h"
#include "hopper/rathole.h"
#include "hopper/solid_made.h"

#define GRID 200 // stresses of the slow search

/** Pieces 0.6 + 0.25 x up to 2, -1.9 + 1.5 x up to 3, and 2.125581 + 0.158140 x, in kPa. */
static void make_kinked(made *self)
{
    make_solid(self, 50.0, 20.0, 1300.0);
    add_strength(self, 1.0, 0.85);
    add_strength(self, 2.0, 1.1);
    add_strength(self, 3.0, 2.6);
    add_strength(self, 24.5, 6.0);
}

/** With a constant flow factor, crossings are a/(1/ff - b); an outlet has sigma_1/ff H/(rho g). */
static void the_last_of_three_crossings_is_critical(void **state)
{
    (void)state;
    static made of;
    make_kinked(&of);
    const clod_hopper_wish wish = wish_of(CLOD_RADIAL_CONE, 20.0, CLOD_HOPPER_ARCH_ARNOLD);
    const clod_hopper_design at = clod_hopper_design_shape(&of.solid, &wish);
    const double ray = 1.0 / at.flow_factor;
    const double size = ray * 150.0 / 65.0 / (1300.0 * CLOD_HOPPER_GRAVITY); // m/Pa, theta 20
    assert_true(ray > 0.7 && ray < 0.85); // of Jenike's charts, where all three are
    assert_int_equal(at.outcome, CLOD_HOPPER_FLOWS);
    check_relative(at.state.sigma_1, 1e3 * 2.125581 / (ray - 0.158140), 1e-5);
    check_relative(at.outlet, size * at.state.sigma_1, 1e-6);
    const clod_ranges lower = clod_ranges_of_outlets(&of.solid, &wish, &at);
    assert_int_equal(lower.count, 1);
    check_relative(lower.of[0].from, size * 1e3 * 0.6 / (ray - 0.25), 1e-5);
    check_relative(lower.of[0].to, size * 1e3 * 1.9 / (1.5 - ray), 1e-5);
    assert_true(clod_ranges_hold(&lower, 0.5 * (lower.of[0].from + lower.of[0].to)));
    assert_false(clod_ranges_hold(&lower, 0.99 * lower.of[0].from));
    assert_false(clod_ranges_hold(&lower, 1.01 * lower.of[0].to));
}

/** The last piece, 1.7 x - 2.5 from 3 kPa on, stays above any ray: no outlet is large enough. */
static void a_curve_that_ends_above_arches(void **state)
{
    (void)state;
    static made of;
    make_solid(&of, 50.0, 20.0, 1300.0);
    add_strength(&of, 1.0, 0.85);
    add_strength(&of, 3.0, 1.0);
    add_strength(&of, 6.0, 6.1);
    const clod_hopper_wish wish = wish_of(CLOD_RADIAL_CONE, 20.0, CLOD_HOPPER_ARCH_ARNOLD);
    const clod_hopper_design at = clod_hopper_design_shape(&of.solid, &wish);
    assert_int_equal(at.outcome, CLOD_HOPPER_ARCHES);
    assert_true(isinf(at.outlet));
    const clod_ranges lower = clod_ranges_of_outlets(&of.solid, &wish, &at);
    const double ray = 1.0 / at.flow_factor;
    const double size = ray * 150.0 / 65.0 / (1300.0 * CLOD_HOPPER_GRAVITY);
    assert_int_equal(lower.count, 1);
    check_relative(lower.of[0].from, size * 1e3 * 0.775 / (ray - 0.075), 1e-5);
    check_relative(lower.of[0].to, size * 1e3 * 4.1 / (1.7 - ray), 1e-5);
}

static void a_straight_flow_function_has_no_lower_outlets(void **state)
{
    (void)state;
    static made of;
    make_solid(&of, 45.0, 20.0, 1500.0);
    add_strength(&of, 2.0, 1.6);
    add_strength(&of, 9.0, 3.7);
    const clod_hopper_wish wish = wish_of(CLOD_RADIAL_CONE, 20.0, CLOD_HOPPER_ARCH_ARNOLD);
    const clod_hopper_design at = clod_hopper_design_shape(&of.solid, &wish);
    check_relative(at.state.sigma_1, 1000.0 / (1.0 / at.flow_factor - 0.3), 1e-6);
    assert_int_equal(clod_ranges_of_outlets(&of.solid, &wish, &at).count, 0);
    const clod_rathole_silo none = {0.0, 0.0, 0.4};
    const clod_rathole hole = clod_rathole_of(&of.solid, &none);
    assert_int_equal(clod_rathole_ranges(&of.solid, &hole).count, 0);
}

/**
 * phi_e 45, phi_t 40: ff_p = 2.16857 (test_rathole.c), its ray 0.461133. Pieces 1.3 + 0.05 x up to 4, -2.5 + x up
 * to 6, 2.857143 + 0.107143 x: crossings at 3.16200, 4.63936 and 8.07126 kPa. G has four digits.
 */
static void the_widest_rathole_counts(void **state)
{
    (void)state;
    static made of;
    make_solid(&of, 45.0, 20.0, 1500.0);
    add_strength(&of, 2.0, 1.4);
    add_strength(&of, 4.0, 1.5);
    add_strength(&of, 6.0, 3.5);
    add_strength(&of, 20.0, 5.0);
    const clod_rathole_silo none = {0.0, 0.0, 0.4};
    const clod_rathole hole = clod_rathole_of(&of.solid, &none);
    const double size = 461.133 * 3.593 / (1500.0 * 9.80665); // m/kPa
    check_relative(hole.emptying, size * 8.07126, 4e-4);
    const clod_ranges lower = clod_rathole_ranges(&of.solid, &hole);
    assert_int_equal(lower.count, 1);
    check_relative(lower.of[0].from, size * 3.16200, 4e-4);
    check_relative(lower.of[0].to, size * 4.63936, 4e-4);
    of.strength[3].y = 20e3; // 1.18 x - 3.57: at any diameter
    assert_true(isinf(clod_rathole_of(&of.solid, &none).emptying));
}

/** Strength over what an arch needs at a stress, in a cone: by the stress field alone. */
static double strength_over_stress(const clod_solid *solid, double half_angle, double sigma_1)
{
    const clod_solid_state at = clod_solid_at(solid, sigma_1);
    const clod_radial field = {CLOD_RADIAL_CONE, at.phi_e, at.phi_w, CLOD_RADIAL_TOLERANCE};
    clod_radial_wall wall;
    assert_true(clod_radial_solve(&field, half_angle, &wall));
    const double arch = (130.0 + half_angle / DEGREE) / 65.0;
    return at.strength * arch * wall.sigma_1 / (2.0 * sin(half_angle)) / sigma_1;
}

/** Nothing stands above the outlet of a design, looked at stress for stress, and something just below it. */
static clod_hopper_outcome check_design(const made *of)
{
    const clod_hopper_wish wish = wish_of(CLOD_RADIAL_CONE, 12.0, CLOD_HOPPER_ARCH_ARNOLD);
    const clod_hopper_design at = clod_hopper_design_shape(&of->solid, &wish);
    const bool flows = at.outcome == CLOD_HOPPER_FLOWS;
    const double first = flows ? at.state.sigma_1 * 1.0001 : 100.0;
    double over = 0.0;
    for (int k = 0; k < GRID; k++) {
        over = strength_over_stress(&of->solid, wish.half_angle,
                                    first * pow(1e8 / first, (double)k / (GRID - 1)));
        assert_true(at.outcome == CLOD_HOPPER_ARCHES || over < 1.0);
    }
    assert_true(at.outcome != CLOD_HOPPER_ARCHES || over > 1.0);
    if (flows) {
        assert_true(
            strength_over_stress(&of->solid, wish.half_angle, at.state.sigma_1 * 0.9999) > 1.0);
    }
    return at.outcome;
}

/** Likewise of ratholes. */
static void check_rathole(const made *of, int found[3])
{
    const clod_rathole_silo none = {0.0, 0.0, 0.4};
    const clod_rathole hole = clod_rathole_of(&of->solid, &none);
    const bool stands = hole.emptying > 0.0 && isfinite(hole.emptying);
    const double first = stands ? hole.state.sigma_1 * 0.9999 : 100.0;
    double over = 0.0;
    for (int k = 0; k < GRID; k++) {
        const double sigma_1 =
            k == 0 ? first : first * 1.0002 * pow(1e8 / first, (double)(k - 1) / (GRID - 2));
        const clod_solid_state at = clod_solid_at(&of->solid, sigma_1);
        const double s = sin(at.phi_e);
        over = at.strength / sigma_1 *
               fmax(1.7, (1.0 + s) / (4.0 * s) * clod_rathole_function(at.phi_t));
        assert_true(isinf(hole.emptying) || (over < 1.0) == !(stands && k == 0));
    }
    assert_true(!isinf(hole.emptying) || over > 1.0);
    found[isinf(hole.emptying) ? 2 : stands]++;
}

/**
 * phi_e that falls from 60 to 35 deg between 2 and 4 kPa makes ff rise from some 1.15 to 1.6, so a straight flow
 * function, 0.3 + 0.55 x, crosses it below 2 kPa, its smallest, and again above 4 kPa.
 */
static void phi_e_may_bring_a_second_crossing(void **state)
{
    (void)state;
    static made of;
    static clod_curve_point phi_e[] = {{.x = 2e3, .y = 60.0 * DEGREE},
                                       {.x = 4e3, .y = 35.0 * DEGREE}};
    make_solid(&of, 45.0, 15.0, 1500.0);
    of.solid.phi_e = (clod_curve){.way = CLOD_CURVE_HELD, .points = phi_e, .count = 2};
    add_strength(&of, 2.0, 0.3 + 0.55 * 2.0);
    add_strength(&of, 20.0, 0.3 + 0.55 * 20.0);
    assert_int_equal(check_design(&of), CLOD_HOPPER_FLOWS);
    const clod_hopper_wish wish = wish_of(CLOD_RADIAL_CONE, 12.0, CLOD_HOPPER_ARCH_ARNOLD);
    assert_true(strength_over_stress(&of.solid, wish.half_angle, 2e3) < 1.0);
    assert_true(clod_hopper_design_shape(&of.solid, &wish).state.sigma_1 > 4e3);
}

/** Solids of five points and three angles drawn at random, of which many cross more than once. */
static void no_arch_stands_above_the_outlets_of_many_solids(void **state)
{
    (void)state;
    static made of;
    static clod_curve_point phi_e[3], phi_t[3];
    uint64_t random = 1;
    int found[6] = {0}, holes[3] = {0};
    for (int solid = 0; solid < 120; solid++) {
        double drawn[13];
        for (int k = 0; k < 13; k++) { // Knuth's MMIX
            random = random * 6364136223846793005U + 1442695040888963407U;
            drawn[k] = (double)(random >> 11) / 9007199254740992.0;
        }
        make_solid(&of, 45.0, 15.0, 1500.0);
        double sigma_1 = 0.5 + drawn[0];
        for (int k = 0; k < 5; k++, sigma_1 *= 1.3 + drawn[k]) {
            add_strength(&of, sigma_1, sigma_1 * (0.1 + 0.9 * drawn[k + 5] / (1.0 + 0.2 * k)));
        }
        for (int k = 0; k < 3; k++) {
            phi_e[k].x = 1e3 * (1.0 + 3.0 * k);
            phi_e[k].y = (35.0 + 25.0 * drawn[k + 10]) * DEGREE;
            phi_t[k] = (clod_curve_point){.x = phi_e[k].x, .y = 0.9 * phi_e[k].y};
        }
        of.solid.phi_e = (clod_curve){.way = CLOD_CURVE_HELD, .points = phi_e, .count = 3};
        of.solid.phi_t = (clod_curve){.way = CLOD_CURVE_HELD, .points = phi_t, .count = 3};
        check_rathole(&of, holes);
        found[check_design(&of)]++;
    }
    assert_true(found[CLOD_HOPPER_FLOWS] > 20 && found[CLOD_HOPPER_ARCHES] > 5);
    assert_int_equal(found[CLOD_HOPPER_UNSETTLED], 0);
    assert_true(holes[1] > 20 && holes[2] > 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_last_of_three_crossings_is_critical),
        cmocka_unit_test(a_curve_that_ends_above_arches),
        cmocka_unit_test(a_straight_flow_function_has_no_lower_outlets),
        cmocka_unit_test(the_widest_rathole_counts),
        cmocka_unit_test(phi_e_may_bring_a_second_crossing),
        cmocka_unit_test(no_arch_stands_above_the_outlets_of_many_solids),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
