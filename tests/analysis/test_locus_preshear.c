// Points that share one preshear share its measurement and its error: the rule, Monte Carlo.

#include "locus_helpers.h"

#include "analysis/preshear.h"

#define COUNT 5
static const double STRESSES[COUNT] = {2e3, 3.5e3, 5e3, 6.5e3, 8e3};

// Both change the prorated points by about the same, so that neither hides the other.
static const double PRESHEAR = 85.0; // Pa, of tau_p; 1 %
static const double SHEAR = 40.0;    // Pa, of tau_s

enum { TRIALS = 8000 };
/**
 * Four standard errors of a ratio of reported and true error: of the true one 1/sqrt(2 TRIALS)
 * = 0.8 % and of the reported one at most 0.5 % (where it varies with the points).
 */
static const double TOLERANCE = 0.04;

/**
 * One noisy test of c = 2 kPa, phi = 35 deg, preshear (10, 8.5) kPa, all errors stated. Its
 * points are sheared at one preshear, or the later half at a second one of `step` times the
 * stress.
 */
static clod_locus noisy_test(uint64_t trial, size_t count, double step)
{
    static clod_status status;
    clod_locus_point points[COUNT];
    points_on_line(2e3, 35.0 * DEG, 10e3, 8.5e3, STRESSES, count, points);
    for (size_t i = 0; i < count; i++) {
        const bool second = step > 1.0 && 2 * i >= count;
        points[i].seed = 3;
        points[i].sigma_p *= second ? step : 1.0;
        points[i].tau_p += PRESHEAR * normal(trial, second ? 1 : 0, 0); // all points as one
        points[i].tau_s += SHEAR * normal(trial, i, 1);
        points[i].tau_p_error = PRESHEAR;
        points[i].tau_s_error = SHEAR;
    }
    clod_locus locus;
    assert_true(clod_locus_evaluate(points, count, &locus, &status));
    return locus;
}

/** Root mean square of the reported error over the scatter between trials, field by field. */
static void compare(size_t count, double step, double ratio[CLOD_FIELD_COUNT])
{
    trial_means means = {.value = {0.0}};
    for (uint64_t k = 0; k < TRIALS; k++) {
        clod_locus locus = noisy_test(k, count, step);
        trial_means_add(&means, &locus, TRIALS);
        clod_locus_fini(&locus);
    }
    trial_means_ratios(&means, ratio);
}

/** The ratio of a field is that of theory, within the tolerance. */
static void expect_ratio(const double *ratio, clod_field_index field, double low, double high)
{
    if (!(ratio[field] >= low * (1.0 - TOLERANCE) &&
          ratio[field] <= high * (1.0 + TOLERANCE))) {
        fail_msg("%s: reported/true error = %.3f, expected %.3f to %.3f within %.0f %%",
                 CLOD_FIELDS[field].key, ratio[field], low, high, 100.0 * TOLERANCE);
    }
}

// Two points lie on their line: nothing is added to the stated errors, so the reported error is
// the true one. With independent tau_p those of tau_p and phi_sf would be 1/sqrt(2) of it. What
// follows from the line far outside of the two points is no longer linear in the errors and
// left out.
static void two_points_of_one_preshear_have_the_true_errors(void **state)
{
    (void)state;
    double ratio[CLOD_FIELD_COUNT];
    compare(2, 1.0, ratio);
    expect_ratio(ratio, CLOD_FIELD_TAU_P, 1.0, 1.0);
    expect_ratio(ratio, CLOD_FIELD_PHI_SF, 1.0, 1.0);
    expect_ratio(ratio, CLOD_FIELD_C, 1.0, 1.0);
    expect_ratio(ratio, CLOD_FIELD_PHI_LIN, 1.0, 1.0);
}

// tau_p and phi_sf have the one stated error: ratio 1, with independent tau_p 1/sqrt(5) = 0.45.
// The line does not know tau_p: the factor mean(tau_p)/tau_p is 1. Its points scatter by X =
// SSE/ SHEAR^2, chi-squared of k = 3 degrees of freedom, and what exceeds the stated k is added
// to the variance: E max(X - k, 0) = 2 k f(k), f the density of chi-squared, so that the
// variance is 1 + 2 f(3) = 1 + 2 sqrt(3/(2 pi)) exp(-1.5) = 1.3084 times the true one, its
// root 1.1438. What follows from line and tau_p lies between.
static void five_points_of_one_preshear_have_its_error_once(void **state)
{
    (void)state;
    const double line = sqrt(1.0 + 2.0 * sqrt(1.5 / PI) * exp(-1.5));
    double ratio[CLOD_FIELD_COUNT];
    compare(COUNT, 1.0, ratio);
    expect_ratio(ratio, CLOD_FIELD_TAU_P, 1.0, 1.0);
    expect_ratio(ratio, CLOD_FIELD_PHI_SF, 1.0, 1.0);
    expect_ratio(ratio, CLOD_FIELD_C, line, line);
    expect_ratio(ratio, CLOD_FIELD_PHI_LIN, line, line);
    for (clod_field_index f = CLOD_FIELD_PHI_E; f < CLOD_FIELD_RHO_B; f++) {
        expect_ratio(ratio, f, 1.0, line);
    }
}

// Two preshears of two points each: their difference has one degree of freedom, and as above
// the variance of mean(tau_p) is 1 + 2 f(1) = 1 + 2 exp(-0.5)/sqrt(2 pi) = 1.4839 times the
// true one.
static void two_preshears_of_one_seed_are_independent(void **state)
{
    (void)state;
    const double mean = sqrt(1.0 + 2.0 * exp(-0.5) / sqrt(2.0 * PI));
    double ratio[CLOD_FIELD_COUNT];
    compare(4, 1.01, ratio);
    expect_ratio(ratio, CLOD_FIELD_TAU_P, mean, mean);
    expect_ratio(ratio, CLOD_FIELD_PHI_SF, mean, mean);
}

/** Three points at 3, 5, 7 kPa off the line c = 2 kPa, phi = 35 deg by 30, -60, 30 Pa. */
static void bent_points(double tau_p_error, clod_locus_point points[3])
{
    const double sigma[] = {3e3, 5e3, 7e3};
    points_on_line(2e3, 35.0 * DEG, 10e3, 8.5e3, sigma, 3, points);
    for (size_t i = 0; i < 3; i++) {
        points[i].tau_s += i == 1 ? -60.0 : 30.0;
        points[i].tau_p_error = tau_p_error;
    }
}

// tau_p = 8500 +- 200 Pa once: error of atan(tau_p/sigma_p) = 0.02/(1 + 0.85^2). It explains no
// scatter about the line (see above), whose error is that of a regression: SSE = 6 30^2 for one
// degree of freedom, var c = SSE (1/3 + 25/8). Second order: (200/8500)^2 = 6e-4.
static void one_error_of_tau_p_by_hand(void **state)
{
    (void)state;
    static clod_status status;
    clod_locus_point points[3];
    clod_locus locus;
    bent_points(200.0, points);
    assert_true(clod_locus_evaluate(points, 3, &locus, &status));
    assert_near(locus.tau_p.error, 200.0, 1e-9);
    assert_near(locus.phi_sf.error, 0.02 / (1.0 + 0.85 * 0.85), 1e-3);
    assert_near(locus.c.error, 30.0 * sqrt(6.0 * (1.0 / 3.0 + 25.0 / 8.0)), 1e-3);
    clod_locus_fini(&locus);
}

/** Whether a text has this in it. */
static void assert_told(char *text, const char *words)
{
    if (text == NULL || strstr(text, words) == NULL) {
        fail_msg("\"%s\" is not in:\n%s", words, text);
    }
    clod_locus_free(text);
}

// The printed report of a laboratory: one tau_p for all points, and no error of it. atan(0.85) is 40.36 deg. That of
// the line is as by hand above: 30 Pa sqrt(6 (1/3 + 25/8)) = 137 Pa.
static void an_error_of_tau_p_that_nobody_states_is_not_zero(void **state)
{
    (void)state;
    static clod_status status;
    for (int k = 0; k < 2; k++) {
        clod_locus_point points[3];
        bent_points(0.0, points);
        for (size_t i = 0; k == 1 && i < 3; i++) { // preshears of their own that tell the same
            points[i].rho_b = 1500.0 + 10.0 * (double)i;
        }
        clod_locus_study *study = clod_locus_study_create(points, 3, &status);
        assert_non_null(study);
        const clod_locus *locus = &study->groups[0].locus;
        assert_true(locus->preshear_untold);
        assert_true(isnan(locus->tau_p.error));
        assert_true(isnan(locus->phi_sf.error));
        assert_near(locus->c.error, 30.0 * sqrt(6.0 * (1.0 / 3.0 + 25.0 / 8.0)), 1e-3);
        assert_true(locus->sigma_1.error > 0.0); // of the line alone
        assert_told(clod_locus_table(study), "tau_p        8.500 ±        -  kPa");
        assert_told(clod_locus_table(study), "phi_sf       40.36 ±        -  deg");
        assert_told(clod_locus_table(study), "c            2.000 ±    0.137  kPa");
        assert_told(clod_locus_table(study),
                    k == 1 ? "in a Jenike tester;\n  error of tau_p not known: not in those of "
                             "sigma_1, sigma_2, phi_e, ffc.\n"
                           : "between specimens not included;\n  error of tau_p not known: ");
        assert_told(clod_locus_csv(study), ",8500,,");
        assert_told(clod_locus_json(study),
                    k == 1 ? "in a Jenike tester; error of tau_p not known: not in those of"
                           : "\"errors_note\": \"one specimen: scatter between specimens not "
                             "included; error of tau_p not known");
        clod_locus_study_destroy(&study);
    }
}

// What is stated for a point stays with it; a point without has none, not 0.
static void points_keep_the_errors_that_they_state(void **state)
{
    (void)state;
    static clod_status status;
    clod_locus_point points[3];
    bent_points(200.0, points);
    points[1].tau_s_error = 25.0;
    clod_locus_study *study = clod_locus_study_create(points, 3, &status);
    assert_non_null(study);
    assert_told(clod_locus_json(study), "\"tau_s_error_Pa\": null");
    assert_told(clod_locus_json(study), "\"tau_s_error_Pa\": 25.0");
    clod_locus_study_destroy(&study);
}

// Seeds whose specimens all tell the same tau_p are such a report too; they scatter by their lines.
static void seeds_of_one_tau_p_tell_no_error_of_it(void **state)
{
    (void)state;
    static clod_status status;
    clod_locus_point points[6];
    bent_points(0.0, points);
    bent_points(0.0, points + 3);
    for (size_t i = 3; i < 6; i++) {
        points[i].seed = 1;
        points[i].tau_s += 50.0;
    }
    clod_locus_study *study = clod_locus_study_create(points, 6, &status);
    assert_non_null(study);
    const clod_locus *locus = &study->groups[0].locus;
    assert_true(locus->preshear_untold);
    assert_true(isnan(locus->tau_p.error));
    assert_near(locus->c.error, 25.0, 1e-9); // 50 Pa apart: half of it
    clod_locus_study_destroy(&study);
}

// One specimen has one bulk density: its stated error, or none; three have that of their mean.
static void bulk_density_is_measured_once_per_preshear(void **state)
{
    (void)state;
    static clod_status status;
    const struct {
        double step, stated, expected;
    } CASES[] = {{0.0, 0.0, (double)NAN}, {0.0, 12.0, 12.0}, {30.0, 0.0, 30.0 / sqrt(3.0)}};
    for (size_t k = 0; k < 3; k++) {
        clod_locus_point points[3];
        clod_locus locus;
        bent_points(200.0, points);
        for (size_t i = 0; i < 3; i++) {
            points[i].rho_b = 1500.0 + CASES[k].step * (double)i;
            points[i].rho_inside = points[i].rho_b + 100.0;
            points[i].rho_b_error = CASES[k].stated;
        }
        assert_true(clod_locus_evaluate(points, 3, &locus, &status));
        assert_near(locus.rho_b.value, 1500.0 + CASES[k].step, 1e-12);
        assert_near(locus.rho_inside.value, 1600.0 + CASES[k].step, 1e-12);
        if (CASES[k].step == 0.0) {
            assert_true(isnan(locus.rho_inside.error)); // nobody states one
        } else {
            assert_near(locus.rho_inside.error, CASES[k].expected, 1e-12);
        }
        if (isnan(CASES[k].expected)) {
            assert_true(isnan(locus.rho_b.error));
        } else {
            assert_near(locus.rho_b.error, CASES[k].expected, 1e-12);
        }
        clod_locus_fini(&locus);
    }
}

static void expect_first(const clod_locus_point *points, size_t count, const size_t *expected)
{
    size_t first[COUNT];
    clod_preshear_find(points, count, first);
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(first[i], expected[i]);
    }
}

// The rule of docs/theory/yield-locus.md, "Whose preshear".
static void points_alike_in_all_of_preshear_share_it(void **state)
{
    (void)state;
    clod_locus_point points[COUNT];
    points_on_line(2e3, 35.0 * DEG, 10e3, 8.5e3, STRESSES, COUNT, points);
    expect_first(points, COUNT, (const size_t[]){0, 0, 0, 0, 0});
    points[1].seed = 1; // seeds and stresses are told apart, in any order
    points[3].seed = 1;
    expect_first(points, COUNT, (const size_t[]){0, 1, 0, 1, 0});
    points[4].sigma_p = 10.1e3;
    expect_first(points, COUNT, (const size_t[]){0, 1, 0, 1, 4});
}

/** A column that only some rows fill in tells nothing of whose preshear it was. */
static void a_gap_in_rho_inside_does_not_part_points(void **state)
{
    (void)state;
    clod_locus_point points[COUNT];
    points_on_line(2e3, 35.0 * DEG, 10e3, 8.5e3, STRESSES, COUNT, points);
    points[1].rho_inside = points[3].rho_inside = 1400.0;
    expect_first(points, COUNT, (const size_t[]){0, 0, 0, 0, 0});
}

static void points_that_differ_in_preshear_had_their_own(void **state)
{
    (void)state;
    const size_t own[] = {0, 1, 2, 3, 4};
    for (int k = 0; k < 5; k++) {
        clod_locus_point points[COUNT];
        points_on_line(2e3, 35.0 * DEG, 10e3, 8.5e3, STRESSES, COUNT, points);
        double *const told[] = {&points[2].tau_p, &points[2].tau_p_error, &points[2].rho_b,
                                &points[2].rho_b_error, &points[2].rho_inside};
        for (size_t i = 0; i < COUNT; i++) {
            points[i].rho_inside = 1400.0;
        }
        *told[k] += 1.0; // the others agree by chance
        expect_first(points, COUNT, own);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_points_of_one_preshear_have_the_true_errors),
        cmocka_unit_test(five_points_of_one_preshear_have_its_error_once),
        cmocka_unit_test(two_preshears_of_one_seed_are_independent),
        cmocka_unit_test(one_error_of_tau_p_by_hand),
        cmocka_unit_test(an_error_of_tau_p_that_nobody_states_is_not_zero),
        cmocka_unit_test(seeds_of_one_tau_p_tell_no_error_of_it),
        cmocka_unit_test(points_keep_the_errors_that_they_state),
        cmocka_unit_test(bulk_density_is_measured_once_per_preshear),
        cmocka_unit_test(points_alike_in_all_of_preshear_share_it),
        cmocka_unit_test(points_that_differ_in_preshear_had_their_own),
        cmocka_unit_test(a_gap_in_rho_inside_does_not_part_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
