// Rathole diameters: Jenike's function against a chart read by others, the rest by hand.

#include "hopper/rathole.h"
#include "hopper/solid_made.h"

// Schulze's fig. 10.19 as silo_design read it off: a tenth of the smallest value is the line's
// width, so 2.39 is good to 2 %, and the fit, to Jenike's own curve, to as much: 3 % together.
static void the_function_matches_a_chart(void **state)
{
    (void)state;
    static const double CHART[] = {2.391, 2.947, 3.553, 4.285, 5.056,
                                   6.091, 7.568, 9.462, 11.684};
    for (int k = 0; k < 9; k++) {
        check_relative(clod_rathole_function((30.0 + 5.0 * k) * DEGREE), CHART[k], 0.03);
    }
    check_close(clod_rathole_function(40.0 * DEGREE), 3.593, 5e-4); // as printed with the fit
}

static void beyond_the_chart_nothing_is_known(void **state)
{
    (void)state;
    assert_true(isnan(clod_rathole_function(29.9 * DEGREE)));
    assert_true(isnan(clod_rathole_function(70.1 * DEGREE)));
    assert_true(isnan(clod_rathole_function((double)NAN)));
}

/**
 * f_c = 1 + 0.2 sigma_1 kPa, phi_e 45: (1 + s)/(4 s) = 0.603553, with G(40) = 3.593 ff_p = 2.16857;
 * sigma_1 = 1/(1/2.16857 - 0.2) = 3.82945, f_c = 1.76589 kPa; d = 3.593 x 1765.89/(1500 x 9.80665).
 * G has four digits: half of the last one is 1.4e-4, and as much again by ff_p.
 */
static void emptying_by_hand(void **state)
{
    (void)state;
    static made of;
    make_solid(&of, 45.0, 20.0, 1500.0);
    add_strength(&of, 2.0, 1.4);
    add_strength(&of, 10.0, 3.0);
    const clod_rathole_silo none = {0.0, 0.0, 0.4};
    const clod_rathole hole = clod_rathole_of(&of.solid, &none);
    check_relative(hole.emptying, 3.593 * 1765.89 / (1500.0 * 9.80665), 3e-4);
    assert_true(isnan(hole.filling));
}

/**
 * Janssen, D 3 m, h 8 m, k 0.4, phi_w 20: 4 k tan(phi_w)/D = 0.194117/m;
 * sigma = 1500 x 9.80665/0.194117 x (1 - exp(-1.552936)) = 59741 Pa;
 * f_c = 1000 + 0.2 x 59741 = 12948 Pa.
 */
static void filling_by_hand(void **state)
{
    (void)state;
    static made of;
    make_solid(&of, 45.0, 20.0, 1500.0);
    add_strength(&of, 2.0, 1.4);
    add_strength(&of, 10.0, 3.0);
    const clod_rathole_silo silo = {3.0, 8.0, 0.4};
    const clod_rathole hole = clod_rathole_of(&of.solid, &silo);
    check_relative(hole.filling_stress, 59741.0, 1e-4);
    check_relative(hole.filling, 3.593 * 12948.0 / (1500.0 * 9.80665), 3e-4);
}

static void a_smooth_wall_carries_nothing(void **state)
{
    (void)state;
    static made of;
    make_solid(&of, 45.0, 0.0, 1500.0);
    add_strength(&of, 2.0, 1.4);
    add_strength(&of, 10.0, 3.0);
    const clod_rathole_silo silo = {3.0, 8.0, 0.4};
    check_relative(clod_rathole_of(&of.solid, &silo).filling_stress, 1500.0 * 9.80665 * 8.0,
                   1e-12);
}

/** Time flow function of silo_design's iron concentrate (docs/theory/hopper.md): f_c = 0.8 + 0.22 sigma_1 kPa, rho_b 2400;
 *  sigma_1 = 0.8/(1/1.7 - 0.22) = 2.172524, f_c = sigma_1/1.7 = 1.277955 kPa, b = 1.15 x 1277.955/(2400 x 9.80665). */
static void slot_by_hand(void **state)
{
    (void)state;
    static made of;
    make_solid(&of, 50.0, 20.0, 2400.0);
    add_strength(&of, 2.0, 1.24);
    add_strength(&of, 10.0, 3.0);
    const clod_rathole_slot slot = clod_rathole_slot_of(&of.solid);
    check_relative(slot.width, 1.15 * 1277.955 / (2400.0 * 9.80665), 1e-6);
    check_relative(slot.state.sigma_1, 2172.524, 1e-6);
}

/** f_c below sigma_1/1.7 everywhere, and above it. */
static void slots_without_a_state(void **state)
{
    (void)state;
    static made low, high;
    make_solid(&low, 45.0, 20.0, 1500.0);
    add_strength(&low, 2.0, 1.1);
    add_strength(&low, 10.0, 5.5);
    check_close(clod_rathole_slot_of(&low.solid).width, 0.0, 0.0);
    make_solid(&high, 45.0, 20.0, 1500.0);
    add_strength(&high, 2.0, 1.4);
    add_strength(&high, 10.0, 6.2);
    assert_true(isinf(clod_rathole_slot_of(&high.solid).width));
}

/** Straight from point to point it meets 1/1.7 three times, 2.0, 3.4 and 8.5 kPa: the widest counts. */
static void of_several_widths_the_largest(void **state)
{
    (void)state;
    static made of;
    make_solid(&of, 45.0, 20.0, 1500.0);
    add_strength(&of, 1.0, 1.0);
    add_strength(&of, 3.0, 3.0 / 1.7 - 0.1);
    add_strength(&of, 3.8, 3.8 / 1.7 + 0.1);
    add_strength(&of, 8.5, 5.0);
    add_strength(&of, 10.0, 5.2);
    check_relative(clod_rathole_slot_of(&of.solid).width, 1.15 * 5000.0 / (1500.0 * 9.80665),
                   1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_function_matches_a_chart),
        cmocka_unit_test(beyond_the_chart_nothing_is_known),
        cmocka_unit_test(emptying_by_hand),
        cmocka_unit_test(filling_by_hand),
        cmocka_unit_test(a_smooth_wall_carries_nothing),
        cmocka_unit_test(slot_by_hand),
        cmocka_unit_test(slots_without_a_state),
        cmocka_unit_test(of_several_widths_the_largest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
