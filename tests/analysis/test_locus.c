// Yield locus: the check values of docs/theory/yield-locus.md, tangency found by bisection,
// invariances, limits.

#include "locus_helpers.h"

static const double STRESSES[] = {2e3, 4e3, 6e3, 8e3};
#define COUNT 4

/** Evaluate points on a line; they must be fine. */
static clod_locus evaluate_line(double c, double phi, double sigma_p, double tau_p)
{
    static clod_status status;
    clod_locus_point points[COUNT];
    double sigma[COUNT];
    for (size_t i = 0; i < COUNT; i++) {
        sigma[i] = STRESSES[i] * sigma_p / 1e4;
    }
    points_on_line(c, phi, sigma_p, tau_p, sigma, COUNT, points);
    clod_locus locus;
    assert_true(clod_locus_evaluate(points, COUNT, &locus, &status));
    return locus;
}

/** How much the circle about `centre` through the preshear point stands above the line. */
static double excess(double centre, double c, double phi, double sigma_p, double tau_p)
{
    const double radius = hypot(centre - sigma_p, tau_p);
    const double distance = (c + centre * tan(phi)) * cos(phi); // of the centre from the line
    return radius - distance;
}

/**
 * Centre of the circle through the preshear point that touches the line, by bisection, no
 * formula: for centres far left the line cuts the circle; going right it clears it first at the
 * smaller of the two touching circles.
 */
static double bisect_centre(double c, double phi, double sigma_p, double tau_p)
{
    double low = -c / tan(phi); // apex of the line: distance 0, the circle stands above
    double high = low;
    while (excess(high, c, phi, sigma_p, tau_p) > 0.0) {
        high += 1e-3 * sigma_p; // first step at which it is clear
    }
    for (int k = 0; k < 200; k++) {
        const double middle = 0.5 * (low + high);
        if (excess(middle, c, phi, sigma_p, tau_p) > 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return 0.5 * (low + high);
}

/** Diameter of the circle from the origin that touches the line, by bisection. */
static double bisect_unconfined(double c, double phi)
{
    double low = 0.0;
    double high = 100.0 * c;
    for (int k = 0; k < 200; k++) {
        const double radius = 0.5 * (low + high);
        if ((c + radius * tan(phi)) * cos(phi) > radius) {
            low = radius;
        } else {
            high = radius;
        }
    }
    return low + high;
}

// docs/theory/yield-locus.md: c = 2 kPa, phi = 35 deg, preshear (10, 8.5) kPa; printed digits.
static void check_values_of_the_specification(void **state)
{
    (void)state;
    clod_locus locus = evaluate_line(2e3, 35.0 * DEG, 10e3, 8.5e3);
    assert_near(locus.sigma_1.value, 21598.4, 0.05 / 21598.4);
    assert_near(locus.sigma_2.value, 3770.7, 0.05 / 3770.7);
    assert_near(locus.sigma_c.value, 7683.9, 0.05 / 7683.9);
    assert_near(locus.ffc.value, 2.8108, 0.00005 / 2.8108);
    assert_near(locus.phi_e.value / DEG, 44.647, 0.0005 / 44.647);
    assert_near(locus.phi_sf.value / DEG, 40.365, 0.0005 / 40.365);
    assert_near(locus.c.value, 2e3, 1e-12);
    assert_near(locus.phi_lin.value, 35.0 * DEG, 1e-12);
    assert_near(locus.r_squared, 1.0, 1e-12);
    assert_string_equal(locus.flow, "cohesive");
    assert_false(locus.parallel);
    assert_int_equal(locus.warning_count, 0);
    clod_locus_fini(&locus);
}

// The same and others against circles found by bisection on "circle touches line".
static void circles_touch_the_line(void **state)
{
    (void)state;
    const double cases[][4] = {{2e3, 35.0, 10e3, 8.5e3},
                               {1e2, 25.0, 10e3, 4.6e3},
                               {5e3, 20.0, 20e3, 10e3},
                               {12e3, 45.0, 54.8e3, 60e3},
                               {300.0, 50.0, 38.7e3, 44e3}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        const double c = cases[k][0];
        const double phi = cases[k][1] * DEG;
        const double sigma_p = cases[k][2];
        const double tau_p = cases[k][3];
        assert_true(tau_p < c + sigma_p * tan(phi)); // below the line
        clod_locus locus = evaluate_line(c, phi, sigma_p, tau_p);
        const double centre = bisect_centre(c, phi, sigma_p, tau_p);
        const double radius = hypot(centre - sigma_p, tau_p);
        const double sigma_c = bisect_unconfined(c, phi);
        assert_near(locus.steady.centre, centre, 1e-12);
        assert_near(locus.steady.radius, radius, 1e-12);
        assert_near(locus.sigma_1.value, centre + radius, 1e-12);
        assert_near(locus.sigma_2.value, centre - radius, 1e-11);
        assert_near(locus.sigma_c.value, sigma_c, 1e-11); // c itself comes from a fit
        assert_near(locus.ffc.value, (centre + radius) / sigma_c, 1e-11);
        assert_near(locus.phi_e.value, asin(radius / centre), 1e-12);
        assert_near(locus.unconfined.centre, 0.5 * sigma_c, 1e-11);
        assert_near(locus.unconfined.radius, 0.5 * sigma_c, 1e-11);
        clod_locus_fini(&locus);
    }
}

// The formula as docs/theory/yield-locus.md prints it, with c/tan phi; the code has it without.
static void formula_as_printed(void **state)
{
    (void)state;
    const double c = 2e3;
    const double phi = 35.0 * DEG;
    const double sp = 10e3;
    const double tp = 8.5e3;
    const double a = sp + c / tan(phi);
    const double root = sqrt(a * a * pow(sin(phi), 2.0) - tp * tp * pow(cos(phi), 2.0));
    const double apex = (a - root) / pow(cos(phi), 2.0);
    clod_locus locus = evaluate_line(c, phi, sp, tp);
    assert_near(locus.sigma_1.value, apex * (1.0 + sin(phi)) - c / tan(phi), 1e-12);
    assert_near(locus.sigma_2.value, apex * (1.0 - sin(phi)) - c / tan(phi), 1e-12);
    assert_near(locus.sigma_c.value, 2.0 * c * (1.0 + sin(phi)) / cos(phi), 1e-12);
    clod_locus_fini(&locus);
}

// docs/theory/yield-locus.md, preshear above the line: sigma_1 = sp + tp (1 + sin phi)/cos phi,
// and the circle has the preshear point on it and touches the parallel line there (its radius
// is normal to it).
static void preshear_above_the_line(void **state)
{
    (void)state;
    const double phi = 35.0 * DEG;
    clod_locus locus = evaluate_line(2e3, phi, 10e3, 9.5e3); // the line is at 9.002 kPa
    assert_true(locus.parallel);
    assert_near(locus.sigma_1.value, 10e3 + 9.5e3 * (1.0 + sin(phi)) / cos(phi), 1e-12);
    assert_near(hypot(locus.steady.centre - 10e3, 9.5e3), locus.steady.radius, 1e-12);
    assert_near((locus.steady.centre - 10e3) / 9.5e3, tan(phi), 1e-12);
    assert_true(has_warning(&locus, "lies above the line (9.002 kPa there)"));
    clod_locus_fini(&locus);
}

// Both branches meet where the preshear point is on the line.
static void branches_are_continuous(void **state)
{
    (void)state;
    const double phi = 35.0 * DEG;
    const double on = 2e3 + 10e3 * tan(phi);
    clod_locus below = evaluate_line(2e3, phi, 10e3, on * (1.0 - 1e-13));
    clod_locus above = evaluate_line(2e3, phi, 10e3, on * (1.0 + 1e-13));
    assert_near(below.sigma_1.value, above.sigma_1.value, 1e-5); // a square root opens there
    clod_locus_fini(&below);
    clod_locus_fini(&above);
}

// c = 0: no strength; the locus goes through the origin, the circle by bisection as before.
static void dry_solid(void **state)
{
    (void)state;
    const double phi = 30.0 * DEG;
    clod_locus locus = evaluate_line(0.0, phi, 10e3, 5.5e3);
    const double centre = bisect_centre(0.0, phi, 10e3, 5.5e3);
    assert_true(locus.c.value == 0.0);
    assert_true(locus.sigma_c.value == 0.0);
    assert_true(isinf(locus.ffc.value));
    assert_string_equal(locus.flow, "free flowing");
    assert_near(locus.sigma_1.value, centre + hypot(centre - 10e3, 5.5e3), 1e-12);
    assert_near(locus.phi_e.value, phi, 1e-12); // c = 0: the effective locus is the locus
    assert_near(locus.phi_sf.value, atan(0.55), 1e-12);
    assert_int_equal(locus.warning_count, 0);
    clod_locus_fini(&locus);
}

// phi = 0 (Tresca): the circle has radius c, its centre sqrt(c^2 - tp^2) left of sp.
static void flat_locus(void **state)
{
    (void)state;
    clod_locus locus = evaluate_line(5e3, 0.0, 10e3, 4e3);
    assert_near(locus.steady.radius, 5e3, 1e-12);
    assert_near(locus.steady.centre, 10e3 - 3e3, 1e-12);
    assert_near(locus.sigma_c.value, 10e3, 1e-12); // 2 c
    assert_near(locus.r_squared, 1.0, 1e-12);
    assert_true(has_warning(&locus, "outside 5 to 65 deg"));
    clod_locus_fini(&locus);
}

static void negative_cohesion_leaves_strength_undefined(void **state)
{
    (void)state;
    clod_locus locus = evaluate_line(-500.0, 40.0 * DEG, 10e3, 7.5e3);
    assert_near(locus.c.value, -500.0, 1e-11);
    assert_true(isnan(locus.sigma_c.value) && isnan(locus.sigma_c.error));
    assert_true(isnan(locus.ffc.value) && isnan(locus.ffc.error));
    assert_true(isfinite(locus.sigma_1.value));
    assert_true(isnan(locus.unconfined.radius));
    assert_string_equal(locus.flow, "undefined");
    assert_true(has_warning(&locus, "Cohesion is negative (-0.500 kPa)"));
    clod_locus_fini(&locus);
}

// Any line is found exactly, whatever the preshear of each point: prorating takes it out.
static void exact_lines_come_back(void **state)
{
    (void)state;
    static clod_status status;
    for (uint64_t k = 0; k < 200; k++) {
        const double c = 5e3 * clod_random_uniform(3, CLOD_RANDOM_TEST, k, 0);
        const double phi = (10.0 + 50.0 * clod_random_uniform(3, CLOD_RANDOM_TEST, k, 1)) * DEG;
        clod_locus_point points[5];
        double mean = 0.0;
        for (uint64_t i = 0; i < 5; i++) {
            const double factor =
                1.0 + 0.1 * clod_random_uniform(3, CLOD_RANDOM_TEST, k, 2 + i);
            const double sigma = 1e3 + 1.5e3 * (double)i;
            mean += 8e3 * factor / 5.0;
            points[i] = (clod_locus_point){.sigma_p = 10e3,
                                           .tau_p = 8e3 * factor,
                                           .sigma_s = sigma,
                                           .tau_s = (c + sigma * tan(phi)) * factor};
        }
        clod_locus locus;
        assert_true(clod_locus_evaluate(points, 5, &locus, &status));
        // prorated to mean(tau_p): the line is the one above times mean(tau_p)/8 kPa
        assert_near(locus.c.value, c * mean / 8e3, 1e-9);
        assert_near(tan(locus.phi_lin.value), tan(phi) * mean / 8e3, 1e-11);
        assert_near(locus.tau_p.value, mean, 1e-12);
        for (size_t i = 0; i < 5; i++) {
            assert_near(locus.marks[i].prorated, points[i].tau_s * mean / points[i].tau_p,
                        1e-12);
            assert_near(locus.marks[i].line, locus.marks[i].prorated, 1e-11);
            assert_near(locus.marks[i].measured, points[i].tau_s, 0.0);
        }
        clod_locus_fini(&locus);
    }
}

// All stresses times a factor: stresses and their errors scale, angles and ffc stay.
static void scale_of_stress_does_not_matter(void **state)
{
    (void)state;
    static clod_status status;
    clod_locus found[2];
    for (int k = 0; k < 2; k++) {
        const double scale = k == 0 ? 1.0 : 47.88025898033584; // 1 psf in Pa
        clod_locus_point points[COUNT];
        for (size_t i = 0; i < COUNT; i++) {
            points[i] = (clod_locus_point){
                .sigma_p = scale * 1e4,
                .tau_p = scale * (8.5e3 + 40.0 * normal(5, i, 0)),
                .sigma_s = scale * STRESSES[i],
                .tau_s = scale * (2e3 + 0.7 * STRESSES[i] + 50.0 * normal(5, i, 1)),
                .tau_s_error = scale * 20.0,
                .rho_b = 1500.0 + (double)i};
        }
        assert_true(clod_locus_evaluate(points, COUNT, &found[k], &status));
        const double s = k == 0 ? 1.0 : 1.0 / scale;
        assert_near(s * found[k].sigma_1.value, found[0].sigma_1.value, 1e-12);
        assert_near(s * found[k].sigma_1.error, found[0].sigma_1.error, 1e-9);
        assert_near(s * found[k].c.error, found[0].c.error, 1e-9);
        assert_near(found[k].ffc.value, found[0].ffc.value, 1e-12);
        assert_near(found[k].ffc.error, found[0].ffc.error, 1e-9);
        assert_near(found[k].phi_e.value, found[0].phi_e.value, 1e-12);
        assert_near(found[k].phi_lin.error, found[0].phi_lin.error, 1e-9);
    }
    assert_near(found[0].rho_b.value, 1501.5, 1e-12);
    // 0, 1, 2, 3: standard deviation sqrt(5/3), of the mean half of it
    assert_near(found[0].rho_b.error, 0.5 * sqrt(5.0 / 3.0), 1e-12);
    clod_locus_fini(&found[0]);
    clod_locus_fini(&found[1]);
}

// Jenike's limits as docs/theory/yield-locus.md lists them.
static void classes_of_flow(void **state)
{
    (void)state;
    assert_string_equal(clod_locus_flow(0.99), "not flowing");
    assert_string_equal(clod_locus_flow(1.0), "very cohesive");
    assert_string_equal(clod_locus_flow(1.99), "very cohesive");
    assert_string_equal(clod_locus_flow(2.0), "cohesive");
    assert_string_equal(clod_locus_flow(3.99), "cohesive");
    assert_string_equal(clod_locus_flow(4.0), "easy flowing");
    assert_string_equal(clod_locus_flow(9.99), "easy flowing");
    assert_string_equal(clod_locus_flow(10.01), "free flowing");
    assert_string_equal(clod_locus_flow((double)INFINITY), "free flowing");
    assert_string_equal(clod_locus_flow((double)NAN), "undefined");
}

static void expect_refusal(const clod_locus_point *points, size_t count, const char *text)
{
    static clod_status status;
    clod_locus locus;
    assert_false(clod_locus_evaluate(points, count, &locus, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(status.text, text);
    clod_locus_fini(&locus);
}

static void points_that_give_no_line(void **state)
{
    (void)state;
    clod_locus_point points[COUNT];
    points_on_line(2e3, 35.0 * DEG, 10e3, 8.5e3, STRESSES, COUNT, points);
    expect_refusal(points, 0,
                   "A yield locus needs at least two points, better four; there are 0.");
    expect_refusal(points, 1,
                   "A yield locus needs at least two points, better four; there is 1.");
    points[1].sigma_s = points[0].sigma_s;
    expect_refusal(
        points, 2,
        "All 2 points have the same normal stress, 2.000 kPa to within 1 % of the preshear "
        "stress: a line needs points at different normal stresses.");
    points[2].tau_p = 0.0;
    expect_refusal(points, COUNT,
                   "Point 3: the preshear shear stress is 0; it must be above 0.");
    points[0].tau_s = (double)NAN;
    expect_refusal(points, COUNT,
                   "Point 1: the peak shear stress is nan; it must be 0 or more.");
    points[0].tau_s = -1.0;
    expect_refusal(points, COUNT,
                   "Point 1: the peak shear stress is -1; it must be 0 or more.");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(check_values_of_the_specification),
        cmocka_unit_test(circles_touch_the_line),
        cmocka_unit_test(formula_as_printed),
        cmocka_unit_test(preshear_above_the_line),
        cmocka_unit_test(branches_are_continuous),
        cmocka_unit_test(dry_solid),
        cmocka_unit_test(flat_locus),
        cmocka_unit_test(negative_cohesion_leaves_strength_undefined),
        cmocka_unit_test(exact_lines_come_back),
        cmocka_unit_test(scale_of_stress_does_not_matter),
        cmocka_unit_test(classes_of_flow),
        cmocka_unit_test(points_that_give_no_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
