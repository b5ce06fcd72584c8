// Error bars: the textbook covariance of a line, Monte Carlo, several seeds.

#include "locus_helpers.h"

#define COUNT 5
static const double STRESSES[COUNT] = {2e3, 3.5e3, 5e3, 6.5e3, 8e3};

typedef struct noise {
    double shear;    ///< Pa, of tau_s
    double preshear; ///< Pa, of tau_p
    double specimen; ///< relative, of tau_p and tau_s of one point together
    bool stated;     ///< whether shear and preshear are told to the evaluation
} noise;

/** One noisy test of c = 2 kPa, phi = 35 deg, preshear (10, 8.5) kPa. */
static clod_locus noisy_test(uint64_t trial, const noise *with, size_t count)
{
    static clod_status status;
    clod_locus_point points[COUNT];
    points_on_line(2e3, 35.0 * DEG, 10e3, 8.5e3, STRESSES, count, points);
    for (size_t i = 0; i < count; i++) {
        const double factor = 1.0 + with->specimen * normal(trial, i, 0);
        points[i].tau_s = factor * points[i].tau_s + with->shear * normal(trial, i, 1);
        points[i].tau_p = factor * points[i].tau_p + with->preshear * normal(trial, i, 2);
        points[i].tau_s_error = with->stated ? with->shear : 0.0;
        points[i].tau_p_error = with->stated ? with->preshear : 0.0;
    }
    clod_locus locus;
    assert_true(clod_locus_evaluate(points, count, &locus, &status));
    return locus;
}

/** Root mean square of the reported error over the true standard deviation, field by field. */
static void compare(const noise *with, size_t count, double ratio[CLOD_FIELD_COUNT])
{
    enum { TRIALS = 4000 };
    trial_means means = {.value = {0.0}};
    for (uint64_t k = 0; k < TRIALS; k++) {
        clod_locus locus = noisy_test(k, with, count);
        trial_means_add(&means, &locus, TRIALS);
        clod_locus_fini(&locus);
    }
    trial_means_ratios(&means, ratio);
}

/** Every field's ratio lies between these. */
static void expect_ratios(const noise *with, size_t count, double low, double high)
{
    double ratio[CLOD_FIELD_COUNT];
    compare(with, count, ratio);
    for (clod_field_index f = CLOD_FIELD_TAU_P; f < CLOD_FIELD_RHO_B; f++) {
        if (!(ratio[f] >= low && ratio[f] <= high)) {
            fail_msg("%s: reported/true error = %.3f, expected %.2f to %.2f",
                     CLOD_FIELDS[f].key, ratio[f], low, high);
        }
    }
}

// Regression of y = a + b x (any textbook): s^2 = SSE/(n-2), var b = s^2/Sxx,
// var a = s^2 (1/n + mean^2/Sxx); tau_p all alike and exact, so nothing else adds.
static void errors_of_the_line_are_those_of_a_regression(void **state)
{
    (void)state;
    const noise shear = {.shear = 60.0};
    clod_locus locus = noisy_test(7, &shear, COUNT);
    double mean = 0.0;
    for (size_t i = 0; i < COUNT; i++) {
        mean += STRESSES[i] / COUNT;
    }
    double sse = 0.0;
    double sxx = 0.0;
    for (size_t i = 0; i < COUNT; i++) {
        sse += pow(locus.marks[i].measured - locus.marks[i].line, 2.0);
        sxx += pow(STRESSES[i] - mean, 2.0);
    }
    const double scatter = sqrt(sse / (COUNT - 2));
    const double slope_error = scatter / sqrt(sxx);
    const double slope = tan(locus.phi_lin.value);
    assert_near(locus.c.error, scatter * sqrt(1.0 / COUNT + mean * mean / sxx), 1e-9);
    assert_near(locus.phi_lin.error, slope_error / (1.0 + slope * slope), 1e-4);
    assert_true(isnan(locus.phi_sf.error) && isnan(locus.tau_p.error)); // nothing tells them
    assert_int_equal(locus.errors, CLOD_LOCUS_ERRORS_FIT);
    clod_locus_fini(&locus);
}

// tau_p = 8.5 +- scatter, nothing else: error of the mean is its standard deviation/sqrt(n);
// c and the line go with it, because prorating scales them by mean(tau_p).
static void scatter_of_specimens_moves_the_line(void **state)
{
    (void)state;
    const noise specimens = {.specimen = 0.03};
    clod_locus locus = noisy_test(11, &specimens, COUNT);
    double mean = 0.0;
    double squares = 0.0;
    for (size_t i = 0; i < COUNT; i++) {
        mean += 8.5e3 * (1.0 + 0.03 * normal(11, i, 0)) / COUNT;
    }
    for (size_t i = 0; i < COUNT; i++) {
        squares += pow(8.5e3 * (1.0 + 0.03 * normal(11, i, 0)) - mean, 2.0);
    }
    const double error = sqrt(squares / (COUNT - 1) / COUNT);
    assert_near(locus.tau_p.error, error, 1e-9);
    assert_near(locus.c.error / locus.c.value, error / mean, 1e-6);
    // sigma_c = 2 c (t + sqrt(1 + t^2)): d ln sigma_c = (1 + sin phi) d ln c when t goes with c
    const double rise = 1.0 + sin(locus.phi_lin.value);
    assert_near(locus.sigma_c.error / locus.sigma_c.value, rise * error / mean, 1e-3);
    clod_locus_fini(&locus);
}

/** Three points at 3, 5, 7 kPa of c = 2 kPa, phi = 35 deg, off the line by a, -2a, a. */
static void bent_points(double a, clod_locus_point points[3])
{
    const double sigma[] = {3e3, 5e3, 7e3};
    points_on_line(2e3, 35.0 * DEG, 10e3, 8.5e3, sigma, 3, points);
    points[0].tau_s += a;
    points[1].tau_s -= 2.0 * a;
    points[2].tau_s += a;
}

static double cohesion_error(const clod_locus_point *points, size_t count)
{
    static clod_status status;
    clod_locus locus;
    assert_true(clod_locus_evaluate(points, count, &locus, &status));
    const double error = locus.c.error;
    clod_locus_fini(&locus);
    return error;
}

// Off the line by a, -2a, a the fit stays and SSE = 6 a^2; leverages are 5/6, 1/3, 5/6, so
// stated errors e of tau_s explain (1/6 + 2/3 + 1/6) e^2 = e^2 of it. e^2 = 2 a^2 leaves 4 a^2
// for one degree of freedom: variance 2 a^2 + 4 a^2 per point; var c = that times
// (1/3 + 25/8).
static void scatter_beyond_the_stated_errors_is_added(void **state)
{
    (void)state;
    clod_locus_point points[3];
    const double factor = sqrt(1.0 / 3.0 + 25.0 / 8.0);
    bent_points(30.0, points);
    assert_near(cohesion_error(points, 3), 30.0 * sqrt(6.0) * factor, 1e-9);
    for (size_t i = 0; i < 3; i++) {
        points[i].tau_s_error = 30.0 * sqrt(2.0);
    }
    assert_near(cohesion_error(points, 3), 30.0 * sqrt(6.0) * factor, 1e-9);
    for (size_t i = 0; i < 3; i++) {
        points[i].tau_s_error = 300.0; // explains all of it
    }
    assert_near(cohesion_error(points, 3), 300.0 * factor, 1e-9);
}

// Errors of tau_p explain scatter of the prorated points as well: then nothing is added, and a
// small bend changes the error by its second order only. The specimens differ by less than
// their errors, each with its own preshear (one shared by all: test_locus_preshear.c).
static void errors_of_preshear_explain_scatter(void **state)
{
    (void)state;
    clod_locus_point straight[3];
    clod_locus_point bent[3];
    bent_points(0.0, straight);
    bent_points(30.0, bent);
    const double share[] = {0.999, 1.002, 0.999};
    for (size_t i = 0; i < 3; i++) {
        straight[i].tau_p *= share[i];
        straight[i].tau_s *= share[i];
        straight[i].tau_p_error = 200.0;
        bent[i].tau_p *= share[i];
        bent[i].tau_s *= share[i];
        bent[i].tau_p_error = 200.0;
    }
    assert_near(cohesion_error(bent, 3), cohesion_error(straight, 3), 0.02);
}

// The same prorated points from specimens that differ: the error of the line stays, the one of
// mean(tau_p) comes in addition, c times its relative error.
static void specimens_do_not_change_the_error_of_the_line(void **state)
{
    (void)state;
    const double share[] = {0.6, 1.5, 0.9}; // mean 1, so that mean(tau_p) stays 8.5 kPa
    clod_locus_point points[3];
    bent_points(30.0, points);
    const double alike = cohesion_error(points, 3);
    for (size_t i = 0; i < 3; i++) {
        points[i].tau_p *= share[i];
        points[i].tau_s *= share[i];
    }
    const double of_mean = sqrt((0.16 + 0.25 + 0.01) / 2.0 / 3.0);
    const double total = cohesion_error(points, 3);
    assert_near(sqrt(total * total - pow(2e3 * of_mean, 2.0)), alike, 1e-6);
}

// Monte Carlo, errors not stated: the root mean square of the reported errors is the standard
// deviation between repeats. 4000 repeats tell both to about 2 %; the rest is curvature.
static void monte_carlo_with_scatter_only(void **state)
{
    (void)state;
    const noise shear = {.shear = 40.0};
    double ratio[CLOD_FIELD_COUNT];
    compare(&shear, COUNT, ratio);
    const clod_field_index fields[] = {
        CLOD_FIELD_C,       CLOD_FIELD_PHI_LIN, CLOD_FIELD_PHI_E, CLOD_FIELD_SIGMA_1,
        CLOD_FIELD_SIGMA_2, CLOD_FIELD_SIGMA_C, CLOD_FIELD_FFC};
    for (size_t k = 0; k < sizeof fields / sizeof fields[0]; k++) {
        assert_within(ratio[fields[k]], 0.93, 1.07);
    }
    const noise both = {.shear = 40.0, .specimen = 0.02};
    expect_ratios(&both, COUNT, 0.93, 1.07);
}

// Errors stated and right: what the points scatter beyond them by chance is added on top, so
// the reported errors are a little too large, never too small.
static void monte_carlo_with_stated_errors(void **state)
{
    (void)state;
    const noise measured = {.shear = 40.0, .preshear = 40.0, .stated = true};
    expect_ratios(&measured, COUNT, 0.95, 1.25);
    const noise all = {.shear = 30.0, .preshear = 30.0, .specimen = 0.02, .stated = true};
    expect_ratios(&all, COUNT, 0.95, 1.25);
}

// Two points with stated errors: nothing but the stated errors (and tau_p's scatter).
static void monte_carlo_with_two_points(void **state)
{
    (void)state;
    const noise measured = {.shear = 40.0, .preshear = 40.0, .stated = true};
    expect_ratios(&measured, 2, 0.95, 1.25);
}

static void two_points_without_errors_have_none(void **state)
{
    (void)state;
    const noise shear = {.shear = 40.0};
    clod_locus locus = noisy_test(1, &shear, 2);
    assert_int_equal(locus.errors, CLOD_LOCUS_ERRORS_NONE);
    assert_true(isnan(locus.c.error) && isnan(locus.sigma_1.error) && isnan(locus.ffc.error));
    assert_true(isfinite(locus.c.value));
    clod_locus_fini(&locus);
}

// Seeds: mean, standard deviation and standard error by hand from 1.8, 2.0, 2.5 kPa:
// mean 2.1, deviations -0.3, -0.1, 0.4: squares 0.26, /2 = 0.13, root 0.36056; /sqrt 3 =
// 0.20817
static void seeds_are_combined_by_mean_and_scatter(void **state)
{
    (void)state;
    static clod_status status;
    static clod_locus loci[3];
    const double cohesion[] = {1.8e3, 2.0e3, 2.5e3};
    for (size_t k = 0; k < 3; k++) {
        clod_locus_point points[COUNT];
        points_on_line(cohesion[k], 35.0 * DEG, 10e3, 8.5e3, STRESSES, COUNT, points);
        points[0].seed = (int64_t)k;
        points[0].rho_b = 1400.0 + 100.0 * (double)k;
        points[0].rho_inside =
            k == 0 ? 0.0 : 1600.0 + 100.0 * (double)k; // one cell is too narrow
        assert_true(clod_locus_evaluate(points, COUNT, &loci[k], &status));
    }
    clod_locus all;
    assert_true(clod_locus_combine(loci, 3, &all, &status));
    assert_int_equal(all.errors, CLOD_LOCUS_ERRORS_SEEDS);
    assert_int_equal(all.seed_count, 3);
    assert_int_equal(all.point_count, 3 * COUNT);
    assert_near(all.c.value, 2.1e3, 1e-12);
    assert_near(all.c.scatter, sqrt(0.13) * 1e3, 1e-9);
    assert_near(all.c.error, sqrt(0.13 / 3.0) * 1e3, 1e-9);
    assert_near(all.rho_b.value, 1500.0, 1e-12);
    assert_near(all.rho_b.scatter, 100.0, 1e-12);
    assert_near(all.rho_inside.value, 1750.0, 1e-12); // of the two that tell it
    assert_near(all.rho_inside.scatter, 50.0 * sqrt(2.0), 1e-12);
    assert_near(all.rho_inside.error, 50.0, 1e-12);
    assert_near(all.phi_lin.value, 35.0 * DEG, 1e-12);
    const double sigma_1 =
        (loci[0].sigma_1.value + loci[1].sigma_1.value + loci[2].sigma_1.value) / 3.0;
    assert_near(all.sigma_1.value, sigma_1, 1e-12);
    assert_near(all.steady.centre + all.steady.radius, sigma_1, 1e-12);
    assert_near(all.unconfined.radius, 0.5 * all.sigma_c.value, 1e-12);
    clod_locus one;
    assert_true(clod_locus_combine(loci, 1, &one, &status));
    assert_near(one.c.value, loci[0].c.value, 0.0);
    assert_near(one.c.error, loci[0].c.error, 0.0);
    assert_true(isnan(one.c.scatter));
    assert_true(one.marks != loci[0].marks);
    clod_locus_fini(&one);
    clod_locus_fini(&all);
    for (size_t k = 0; k < 3; k++) {
        clod_locus_fini(&loci[k]);
    }
}

static void a_seed_without_strength_leaves_no_mean(void **state)
{
    (void)state;
    static clod_status status;
    static clod_locus loci[2];
    const double cohesion[] = {-100.0, 120.0};
    for (size_t k = 0; k < 2; k++) {
        clod_locus_point points[COUNT];
        points_on_line(cohesion[k], 35.0 * DEG, 10e3, 6.8e3, STRESSES, COUNT, points);
        assert_true(clod_locus_evaluate(points, COUNT, &loci[k], &status));
    }
    clod_locus all;
    assert_true(clod_locus_combine(loci, 2, &all, &status));
    assert_near(all.c.value, 10.0, 1e-9);
    assert_true(isnan(all.sigma_c.value) && isnan(all.ffc.value));
    assert_string_equal(all.flow, "undefined");
    assert_true(has_warning(&all, "undefined in 1 of 2 seeds"));
    assert_true(has_warning(&all, "Cohesion is zero within two standard errors"));
    clod_locus_fini(&all);
    clod_locus_fini(&loci[0]);
    clod_locus_fini(&loci[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_of_the_line_are_those_of_a_regression),
        cmocka_unit_test(scatter_of_specimens_moves_the_line),
        cmocka_unit_test(scatter_beyond_the_stated_errors_is_added),
        cmocka_unit_test(errors_of_preshear_explain_scatter),
        cmocka_unit_test(specimens_do_not_change_the_error_of_the_line),
        cmocka_unit_test(monte_carlo_with_scatter_only),
        cmocka_unit_test(monte_carlo_with_stated_errors),
        cmocka_unit_test(monte_carlo_with_two_points),
        cmocka_unit_test(two_points_without_errors_have_none),
        cmocka_unit_test(seeds_are_combined_by_mean_and_scatter),
        cmocka_unit_test(a_seed_without_strength_leaves_no_mean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
