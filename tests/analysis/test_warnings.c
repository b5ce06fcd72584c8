// Each warning appears when it should, and not for a good test.

#include "locus_helpers.h"

#include "analysis/fit.h"

/** Expect exactly these warnings. */
static void expect(const clod_locus_point *points, size_t count, const char *first,
                   const char *second)
{
    clod_locus locus = evaluate(points, count);
    const size_t wanted = (first != NULL ? 1u : 0u) + (second != NULL ? 1u : 0u);
    if (locus.warning_count != wanted || (first != NULL && !has_warning(&locus, first)) ||
        (second != NULL && !has_warning(&locus, second))) {
        for (size_t i = 0; i < locus.warning_count; i++) {
            print_message("warning: %s\n", locus.warnings[i]);
        }
        fail_msg("expected %zu warnings: %s, %s", wanted, first == NULL ? "-" : first,
                 second == NULL ? "-" : second);
    }
    clod_locus_fini(&locus);
}

static void good_test_has_none(void **state)
{
    (void)state;
    clod_locus_point points[4];
    good_points(points);
    expect(points, 4, NULL, NULL);
}

static void two_points(void **state)
{
    (void)state;
    clod_locus_point points[4];
    good_points(points);
    expect(points, 2, "Only 2 points: any two points lie on a line; measure at least three.",
           NULL);
}

static void angle_out_of_range(void **state)
{
    (void)state;
    clod_locus_point points[4];
    const double sigma[] = {3e3, 4.5e3, 6e3, 7.5e3};
    points_on_line(4e3, 3.0 * DEG, 10e3, 4.4e3, sigma, 4, points);
    clod_locus locus = evaluate(points, 4);
    assert_true(has_warning(&locus, "phi_lin = 3.00 deg is outside 5 to 65 deg"));
    clod_locus_fini(&locus);
    points_on_line(9e3, -20.0 * DEG, 10e3, 4.4e3, sigma, 4, points);
    locus = evaluate(points, 4);
    assert_true(has_warning(
        &locus, "The line falls (phi_lin = -20.00 deg), so sigma_c and ffc are undefined"));
    assert_true(isnan(locus.sigma_c.value) && isnan(locus.ffc.value) && isnan(locus.ffc.error));
    assert_string_equal(locus.flow, "undefined");
    clod_locus_fini(&locus);
}

/** A good test in another unit: its angles do not tell. 990 kPa and 110 Pa are allowed. */
static void stresses_of_no_tester(void **state)
{
    (void)state;
    const double factor[] = {1e3, 1e-3, 99.0, 0.011};
    const char *said[] = {"The preshear stress is 10000 kPa, more than any hopper has.",
                          "The preshear stress is 0.01 kPa, less than testers can do.", NULL,
                          NULL};
    for (int k = 0; k < 4; k++) {
        clod_locus_point points[4];
        const double f = factor[k], sigma[] = {3e3 * f, 4.5e3 * f, 6e3 * f, 7.5e3 * f};
        points_on_line(1e3 * f, 35.0 * DEG, 10e3 * f, 7.6e3 * f, sigma, 4, points);
        expect(points, 4, said[k], NULL);
    }
}

static void points_outside_the_range(void **state)
{
    (void)state;
    clod_locus_point points[4];
    const double sigma[] = {1.85e3, 3e3, 6e3, 8.05e3};
    points_on_line(100.0, 35.0 * DEG, 10e3, 7.0e3, sigma, 4, points);
    expect(points, 4, "Shear at 1.850 kPa is outside 20 to 80 % of the preshear stress.", NULL);
    points[0].sigma_s = 1.95e3; // within the slack of 1 % of sigma_p, as 8.05 is
    points[0].tau_s = 100.0 + 1.95e3 * tan(35.0 * DEG);
    expect(points, 4, NULL, NULL);
}

static void shear_above_preshear(void **state)
{
    (void)state;
    clod_locus_point points[4];
    const double sigma[] = {3e3, 4.5e3, 6e3, 10.5e3};
    points_on_line(1e3, 35.0 * DEG, 10e3, 7.9e3, sigma, 4, points);
    clod_locus locus = evaluate(points, 4);
    assert_true(has_warning(&locus, "Shear at 10.500 kPa is above the preshear stress"));
    clod_locus_fini(&locus);
}

// c = 2.5 kPa, phi = 35 deg: sigma_c = 9.6049 kPa, touched at half of it times 1 - sin 35 deg
// = 2.0479 kPa (by hand).
static void point_left_of_the_unconfined_circle(void **state)
{
    (void)state;
    clod_locus_point points[4];
    const double sigma[] = {2.0e3, 4e3, 6e3, 7.5e3};
    points_on_line(2.5e3, 35.0 * DEG, 10e3, 9.0e3, sigma, 4, points);
    expect(points, 4,
           "Shear at 2.000 kPa is left of where the unconfined circle touches the line "
           "(2.048 kPa)",
           NULL);
}

// Preshear well below the line: the steady circle is small and touches far left, at 5.663 kPa
// (centre by bisection, as in test_locus.c, outside this program). 6 kPa is within the slack.
static void point_right_of_the_steady_circle(void **state)
{
    (void)state;
    clod_locus_point points[4];
    const double sigma[] = {3e3, 4.5e3, 6e3, 7.9e3};
    points_on_line(1e3, 35.0 * DEG, 10e3, 6.0e3, sigma, 4, points);
    expect(points, 4,
           "Shear at 7.900 kPa is far right of where the steady-state circle touches the line "
           "(5.663 kPa)",
           NULL);
}

static void preshear_of_different_consolidations(void **state)
{
    (void)state;
    clod_locus_point points[4];
    good_points(points);
    points[3].sigma_p = 10.3e3;
    expect(points, 4, "Preshear stresses from 10.000 to 10.300 kPa are more than 2 % apart",
           NULL);
}

// A parabola with a sag of 4 % of the middle: (x - m)^2 over 3..7.5 kPa with a = -b/(range)^2.
static void points_that_bend(void **state)
{
    (void)state;
    clod_locus_point points[5];
    for (size_t i = 0; i < 5; i++) {
        const double x = (double)i - 2.0;
        points[i] = (clod_locus_point){.sigma_p = 10e3,
                                       .tau_p = 7.5e3,
                                       .sigma_s = 5e3 + 1e3 * x,
                                       .tau_s = 4.5e3 + 0.7e3 * x - 60.0 * x * x};
    }
    // bow from -2 to +2 times 60 Pa: 4 * 60 = 240 Pa
    expect(points, 5,
           "The points bend: ends lie 0.240 kPa below the line against the middle; "
           "cohesion and sigma_c of a straight line are too high.",
           NULL);
    for (size_t i = 0; i < 5; i++) {
        points[i].tau_s += 120.0 * pow((double)i - 2.0, 2.0);
    }
    expect(points, 5, "ends lie 0.240 kPa above the line against the middle", NULL);
    for (size_t i = 0; i < 5; i++) { // a tenth of it does not matter
        points[i].tau_s -= 54.0 * pow((double)i - 2.0, 2.0);
    }
    expect(points, 5, NULL, NULL);
}

// An exact parabola at uneven places leaves no scatter about the parabola. The sag is the
// coefficient times the range of what is left of x^2 when its line is taken off.
static void sag_of_uneven_points(void **state)
{
    (void)state;
    const double x[] = {0.0, 1.0, 2.0, 6.0, 7.0};
    double y[5];
    double square[5];
    double zero;
    for (size_t i = 0; i < 5; i++) {
        square[i] = x[i] * x[i];
        y[i] = 1.0 + 2.0 * x[i] - 0.3 * square[i];
    }
    const clod_fit line = clod_fit_line(x, y, 5);
    const clod_fit of_square = clod_fit_line(x, square, 5);
    double low = 0.0;
    double high = 0.0;
    for (size_t i = 0; i < 5; i++) {
        const double bow = square[i] - of_square.intercept - of_square.slope * x[i];
        low = fmin(low, bow);
        high = fmax(high, bow);
    }
    assert_near(clod_fit_sag(&line, x, y, 5, &zero), 0.3 * (high - low), 1e-12);
    assert_true(zero < 1e-6);
}

/** Real ore: the last peak lies below the one before, the line is useless (r2 0.635). */
static void points_of_no_line(void **state)
{
    (void)state;
    const double tau[] = {28.28e3, 43.17e3, 51.75e3, 46.01e3};
    clod_locus_point points[4];
    for (size_t i = 0; i < 4; i++) {
        points[i] = (clod_locus_point){.sigma_p = 54.8e3,
                                       .tau_p = 47.97e3,
                                       .sigma_s = 10.96e3 * (double)(i + 1),
                                       .tau_s = tau[i]};
    }
    clod_locus locus = evaluate(points, 4);
    assert_true(has_warning(&locus,
                            "The shear stress falls from 51.750 to 46.010 kPa while the "
                            "normal stress rises from 32.880 to 43.840 kPa: at least"));
    assert_true(has_warning(&locus, "phi_lin = 29.4 +- 13.1 deg, r2 = 0.635: the points do not "
                                    "lie on a line"));
    assert_true(has_warning(&locus, "No point of this line lies between the circles"));
    assert_true(has_warning(&locus, "sigma_c is a rough estimate."));
    assert_false(has_warning(&locus, "shear at higher"));
    assert_false(has_warning(&locus, "shear at lower"));
    clod_locus_fini(&locus);
}

// d (1, -3, 3, -1) at four places h apart has neither slope nor bend; the slope's standard
// error is sqrt(20 d^2/2/(5 h^2)) = d sqrt(2)/h, that of phi cos^2 phi times it: 3 deg at d
// = 82.8 Pa for h = 1.5 kPa and phi = 35 deg (0.05236/0.67101 * 1.5 kPa/1.41421).
static void angle_with_a_wide_error(void **state)
{
    (void)state;
    clod_locus_point points[4];
    const double off[] = {1.0, -3.0, 3.0, -1.0};
    good_points(points);
    for (size_t i = 0; i < 4; i++) {
        points[i].tau_s += 82.0 * off[i];
    }
    expect(points, 4, NULL, NULL);
    for (size_t i = 0; i < 4; i++) {
        points[i].tau_s += 1.5 * off[i];
    }
    expect(points, 4, "phi_lin = 35.0 +- 3.0 deg, r2 = 0.975: the points do not lie on a line",
           NULL);
}

// Slope 0.1 over -2 to 2 kPa: sum (0.1 x)^2 = 0.1 kPa^2. d (1, -2, 0, 2, -1) has neither slope
// nor bend and adds 10 d^2: r2 = 0.95 at d = sqrt(0.1/190) kPa = 22.94 Pa.
static void points_far_from_a_flat_line(void **state)
{
    (void)state;
    const double off[] = {1.0, -2.0, 0.0, 2.0, -1.0};
    clod_locus_point points[5];
    for (int turn = 0; turn < 2; turn++) {
        const double d = turn == 0 ? 22.5 : 23.5;
        for (int i = 0; i < 5; i++) {
            points[i] = (clod_locus_point){.sigma_p = 10e3,
                                           .tau_p = 2.4e3,
                                           .sigma_s = 5e3 + 1e3 * (i - 2),
                                           .tau_s = 2e3 + 100.0 * (i - 2) + d * off[i]};
        }
        clod_locus locus = evaluate(points, 5);
        assert_true(locus.phi_lin.error < 1.0 * DEG);
        assert_true(has_warning(&locus, "the points do not lie on a line") == (turn == 1));
        clod_locus_fini(&locus);
    }
}

/** A fall within two of the errors that the points state, or within 2 % of tau, is chance. */
static void fall_within_errors_is_chance(void **state)
{
    (void)state;
    const char words[] = "The shear stress falls from 5.000 to 4.700 kPa";
    clod_locus_point points[4];
    const double sigma[] = {3e3, 4.5e3, 6e3, 7.5e3};
    points_on_line(1e3, 35.0 * DEG, 10e3, 7.6e3, sigma, 4, points);
    points[2].tau_s = 5e3;
    points[3].tau_s = 4.7e3;
    const double error[] = {0.0, 105.0, 107.0}; // 0.3/2/sqrt(2) = 0.10607
    for (size_t k = 0; k < 3; k++) {
        points[2].tau_s_error = error[k];
        points[3].tau_s_error = error[k];
        clod_locus locus = evaluate(points, 4);
        assert_true(has_warning(&locus, words) == (k < 2));
        clod_locus_fini(&locus);
    }
    points[3].tau_s_error = points[2].tau_s_error = 0.0;
    points[3].tau_s = 4.95e3; // 0.05 is below 2 % of 4.3 kPa
    clod_locus locus = evaluate(points, 4);
    assert_false(has_warning(&locus, "falls"));
    clod_locus_fini(&locus);
    points[3].tau_s = 4.7e3;
    points[3].sigma_s = 6.05e3; // a repeat of the point before
    locus = evaluate(points, 4);
    assert_false(has_warning(&locus, "falls"));
    clod_locus_fini(&locus);
}

// c = 12.3 kPa, phi = 35 deg: half of sigma_c is 23.63 kPa, times 1 - sin 35 deg = 10.08 kPa,
// above the preshear stress: no point can be sheared at a higher normal stress.
static void unconfined_circle_beyond_preshear(void **state)
{
    (void)state;
    clod_locus_point points[4];
    const double sigma[] = {3e3, 4.5e3, 6e3, 7.5e3};
    points_on_line(12.3e3, 35.0 * DEG, 10e3, 19.2e3, sigma, 4, points);
    clod_locus locus = evaluate(points, 4);
    assert_true(has_warning(&locus, "No point of this line lies between the circles (the "
                                    "unconfined one touches it at 10.07"));
    assert_true(has_warning(&locus, "sigma_c is an extrapolation."));
    assert_false(has_warning(&locus, "shear at higher"));
    clod_locus_fini(&locus);
}

// Angles of 25 and 35 deg: mean 30, standard error of the mean 5 deg.
static void seeds_that_differ(void **state)
{
    (void)state;
    static clod_status status;
    const double sigma[] = {3e3, 4.5e3, 6e3, 7.5e3};
    clod_locus loci[2];
    clod_locus all;
    clod_locus_point points[4];
    for (int k = 0; k < 2; k++) {
        points_on_line(1e3, (25.0 + 10.0 * k) * DEG, 10e3, 5.5e3 + 2.1e3 * k, sigma, 4, points);
        loci[k] = evaluate(points, 4);
        assert_int_equal(loci[k].warning_count, 0);
    }
    assert_true(clod_locus_combine(loci, 2, &all, &status));
    assert_int_equal(all.warning_count, 1);
    assert_true(has_warning(&all, "phi_lin = 30.0 +- 5.0 deg over 2 seeds"));
    clod_locus_fini(&all);
    clod_locus_fini(&loci[0]);
    clod_locus_fini(&loci[1]);
}

static void tension_at_steady_state(void **state)
{
    (void)state;
    clod_locus_point points[4];
    const double sigma[] = {3e3, 4.5e3, 6e3, 7.5e3};
    points_on_line(9e3, 30.0 * DEG, 10e3, 14e3, sigma, 4, points);
    clod_locus locus = evaluate(points, 4);
    assert_true(locus.sigma_2.value < 0.0);
    assert_true(isnan(locus.phi_e.value) && isnan(locus.phi_e.error));
    assert_true(has_warning(&locus, "is tension: phi_e is undefined."));
    clod_locus_fini(&locus);
}

static void negative_cohesion_within_its_error(void **state)
{
    (void)state;
    clod_locus_point points[4];
    const double sigma[] = {3e3, 4.5e3, 6e3, 7.5e3};
    points_on_line(-20.0, 35.0 * DEG, 10e3, 6.9e3, sigma, 4, points);
    points[1].tau_s -= 30.0;
    points[2].tau_s += 30.0;
    clod_locus locus = evaluate(points, 4);
    assert_true(locus.c.value < 0.0);
    assert_true(has_warning(&locus, "It is zero within two standard errors"));
    clod_locus_fini(&locus);
}

/** Nothing flows freely at 79 deg: the angle is odd, and no more can be said of the cohesion. */
static void negative_cohesion_of_an_odd_angle(void **state)
{
    (void)state;
    clod_locus_point points[4];
    const double sigma[] = {3e3, 4.5e3, 6e3, 7.5e3};
    points_on_line(-1e3, 79.0 * DEG, 10e3, 50e3, sigma, 4, points);
    points[1].tau_s -= 3000.0;
    points[2].tau_s += 3000.0;
    clod_locus locus = evaluate(points, 4);
    assert_true(locus.c.value < 0.0 && locus.c.value + 2.0 * locus.c.error > 0.0);
    assert_true(has_warning(&locus, "Cohesion is negative"));
    assert_true(has_warning(&locus, "is outside 5 to 65 deg; check the columns and units."));
    assert_false(has_warning(&locus, "flows freely"));
    clod_locus_fini(&locus);
}

/** More warnings than there is room for are counted, none is written beyond. */
static void room_for_warnings_ends(void **state)
{
    (void)state;
    static clod_status status;
    static clod_locus loci[30];
    for (size_t k = 0; k < 30; k++) {
        clod_locus_point points[4];
        good_points(points);
        for (size_t i = 0; i < 2; i++) {
            points[i].seed = (int64_t)k + 1;
        }
        loci[k] = evaluate(points, 2);
    }
    clod_locus all;
    assert_true(clod_locus_combine(loci, 30, &all, &status));
    assert_int_equal(all.warning_count, CLOD_LOCUS_WARNINGS);
    assert_string_equal(all.warnings[0], "Seed 1: Only 2 points: any two points lie on a line; "
                                         "measure at least three.");
    assert_string_equal(all.warnings[CLOD_LOCUS_WARNINGS - 1],
                        "There are more warnings than these.");
    for (size_t k = 0; k < 30; k++) {
        clod_locus_fini(&loci[k]);
    }
    clod_locus_fini(&all);
}

/** Hundreds of absurd stresses fit into the texts. */
static void long_lists_are_cut(void **state)
{
    (void)state;
    clod_locus_point points[200];
    for (size_t i = 0; i < 200; i++) {
        points[i] = (clod_locus_point){.sigma_p = 1e290 * (1.0 + (double)i),
                                       .tau_p = 1e290,
                                       .sigma_s = 1e289 * (double)i,
                                       .tau_s = 1e289 * (double)i};
    }
    clod_locus locus = evaluate(points, 200);
    assert_true(locus.warning_count > 0);
    clod_locus_fini(&locus);
    for (size_t i = 0; i < 200; i++) {
        points[i] = (clod_locus_point){.sigma_p = 100e3,
                                       .tau_p = 70e3,
                                       .sigma_s = 10.0 * (double)i,
                                       .tau_s = 7.0 * (double)i};
    }
    locus = evaluate(points, 200);
    assert_true(has_warning(&locus, "Shear at 0.000, 0.010, 0.020"));
    assert_true(has_warning(&locus, " ... kPa is outside 20 to 80 %"));
    clod_locus_fini(&locus);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(good_test_has_none),
        cmocka_unit_test(two_points),
        cmocka_unit_test(angle_out_of_range),
        cmocka_unit_test(stresses_of_no_tester),
        cmocka_unit_test(points_outside_the_range),
        cmocka_unit_test(shear_above_preshear),
        cmocka_unit_test(point_left_of_the_unconfined_circle),
        cmocka_unit_test(point_right_of_the_steady_circle),
        cmocka_unit_test(preshear_of_different_consolidations),
        cmocka_unit_test(points_that_bend),
        cmocka_unit_test(sag_of_uneven_points),
        cmocka_unit_test(points_of_no_line),
        cmocka_unit_test(angle_with_a_wide_error),
        cmocka_unit_test(points_far_from_a_flat_line),
        cmocka_unit_test(fall_within_errors_is_chance),
        cmocka_unit_test(unconfined_circle_beyond_preshear),
        cmocka_unit_test(seeds_that_differ),
        cmocka_unit_test(tension_at_steady_state),
        cmocka_unit_test(negative_cohesion_within_its_error),
        cmocka_unit_test(negative_cohesion_of_an_odd_angle),
        cmocka_unit_test(room_for_warnings_ends),
        cmocka_unit_test(long_lists_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
