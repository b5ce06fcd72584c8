// Wall yield loci from points worked out by hand.

#include "clod/wall_locus.h"

#include <string.h>

#include "support/check.h"

#define DEGREES (180.0 / M_PI)

static clod_wall_locus evaluate(const clod_wall_locus_point *points, size_t count)
{
    clod_wall_locus locus;
    clod_status status = {0};
    if (!clod_wall_locus_evaluate(points, count, &locus, &status)) {
        fail_msg("%s", status.text);
    }
    return locus;
}

static void expect_failure(const clod_wall_locus_point *points, size_t count, const char *text)
{
    clod_wall_locus locus;
    clod_status status = {0};
    assert_false(clod_wall_locus_evaluate(points, count, &locus, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_null(locus.marks);
    if (strstr(status.text, text) == NULL) {
        fail_msg("\"%s\" is not in \"%s\"", text, status.text);
    }
}

/**
 * In kPa: means 2.5 and 2, sums of products 5 and 3: slope 0.6, intercept 0.5; off the line by
 * -0.1, 0.3, -0.3, 0.1: variance 0.2/2. Slope: sqrt(0.1/5); intercept: sqrt(0.1 (1/4 + 2.5^2/5)).
 */
static void a_line_through_one_test_has_the_errors_of_its_scatter(void **state)
{
    (void)state;
    const clod_wall_locus_point points[] = {{.sigma = 2e3, .tau = 2e3},
                                            {.sigma = 4e3, .tau = 3e3},
                                            {.sigma = 1e3, .tau = 1e3},
                                            {.sigma = 3e3, .tau = 2e3}};
    clod_wall_locus locus = evaluate(points, 4);
    check_relative(locus.phi_w.value, atan(0.6), 1e-12);
    check_relative(locus.phi_w.error, sqrt(0.02) / 1.36, 1e-12);
    check_relative(locus.tau_ad.value, 500.0, 1e-12);
    check_relative(locus.tau_ad.error, 1e3 * sqrt(0.15), 1e-12);
    assert_true(isnan(locus.phi_w.scatter));
    assert_int_equal(locus.errors, CLOD_LOCUS_ERRORS_FIT);
    assert_true(clod_wall_locus_one_specimen(&locus));
    const double sigma = locus.marks[1].point.sigma;
    locus.marks[1].point.sigma = locus.marks[0].point.sigma; // measured twice
    assert_false(clod_wall_locus_one_specimen(&locus));
    locus.marks[1].point.sigma = sigma;
    // in descending order; tan phi_x = 3/4 at the largest; no error is stated
    assert_int_equal(locus.point_count, 4);
    assert_true(locus.marks[0].point.sigma == 4e3 && locus.marks[3].point.sigma == 1e3);
    check_close(DEGREES * locus.marks[0].phi_x.value, 36.86989764584402, 1e-12);
    assert_true(isnan(locus.marks[0].phi_x.error));
    check_relative(locus.marks[3].line, 1100.0, 1e-12);
    clod_wall_locus_fini(&locus);
}

/**
 * Two points: slope 0.5 through the origin. Errors of 0.1 kPa: of the slope sqrt(2) 0.1/2, of the
 * intercept 0.1 sqrt(1.5^2 + 0.5^2); phi_x at 3 kPa: 0.1/3/(1 + 0.25).
 */
static void stated_errors_carry_over(void **state)
{
    (void)state;
    clod_wall_locus_point points[] = {{.sigma = 1e3, .tau = 500.0, .tau_error = 100.0},
                                      {.sigma = 3e3, .tau = 1500.0, .tau_error = 100.0}};
    clod_wall_locus locus = evaluate(points, 2);
    check_relative(locus.phi_w.error, sqrt(2.0) * 0.05 / 1.25, 1e-12);
    check_relative(locus.tau_ad.error, 100.0 * sqrt(2.5), 1e-12);
    check_close(locus.tau_ad.value, 0.0, 1e-9);
    check_relative(locus.marks[0].phi_x.error, 0.1 / 3.0 / 1.25, 1e-12);
    clod_wall_locus_fini(&locus);
    // the same error in sigma, which the slope makes half as much
    points[0].tau_error = points[1].tau_error = 0.0;
    points[0].sigma_error = points[1].sigma_error = 200.0;
    locus = evaluate(points, 2);
    check_relative(locus.phi_w.error, sqrt(2.0) * 0.05 / 1.25, 1e-12);
    clod_wall_locus_fini(&locus);
    points[0].sigma_error = 0.0; // of one point nothing is known: of the line neither
    locus = evaluate(points, 2);
    assert_true(isnan(locus.phi_w.error) && locus.errors == CLOD_LOCUS_ERRORS_NONE);
    clod_wall_locus_fini(&locus);
}

/** Slopes 0.5 and 0.7: mean angle, scatter of two, which is sqrt(2) times the standard error. */
static void seeds_give_their_mean_and_scatter(void **state)
{
    (void)state;
    const clod_wall_locus_point points[] = {{.seed = 2, .sigma = 1e3, .tau = 700.0},
                                            {.seed = 1, .sigma = 1e3, .tau = 500.0},
                                            {.seed = 2, .sigma = 2e3, .tau = 1400.0},
                                            {.seed = 1, .sigma = 2e3, .tau = 1000.0}};
    clod_wall_locus locus = evaluate(points, 4);
    const double apart = atan(0.7) - atan(0.5);
    assert_int_equal(locus.seed_count, 2);
    assert_int_equal(locus.errors, CLOD_LOCUS_ERRORS_SEEDS);
    check_relative(locus.phi_w.value, 0.5 * (atan(0.5) + atan(0.7)), 1e-12);
    check_relative(locus.phi_w.scatter, apart / sqrt(2.0), 1e-12);
    check_relative(locus.phi_w.error, 0.5 * apart, 1e-12);
    assert_int_equal(locus.marks[0].point.seed, 1);
    check_relative(locus.marks[3].line, 700.0, 1e-12); // of its own seed
    clod_wall_locus_fini(&locus);
}

static void what_is_no_locus_is_refused(void **state)
{
    (void)state;
    clod_wall_locus_point points[] = {{.sigma = 1e3, .tau = 500.0},
                                      {.sigma = 1.005e3, .tau = 500.0}};
    expect_failure(points, 0, "no points");
    expect_failure(points, 1, "better five; there is 1.");
    expect_failure(points, 2, "same wall normal stress, 1.005 kPa");
    points[1].seed = 4;
    expect_failure(points, 2, "there is 1 of seed 0");
    points[1].seed = 0;
    points[1].sigma = 0.0;
    expect_failure(points, 2, "Point 2: a wall normal stress of 0 Pa");
    points[1] = (clod_wall_locus_point){.sigma = 2e3, .tau = 900.0, .tau_error = -1.0};
    expect_failure(points, 2, "errors 0 or more");
}

/** Falling shear stress; a line far below the origin; a bent one. */
static void a_locus_that_is_odd_says_so(void **state)
{
    (void)state;
    const clod_wall_locus_point falls[] = {{.sigma = 1e3, .tau = 500.0},
                                           {.sigma = 2e3, .tau = 400.0}};
    const clod_wall_locus_point below[] = {{.sigma = 1e3, .tau = 100.0},
                                           {.sigma = 2e3, .tau = 500.0},
                                           {.sigma = 3e3, .tau = 900.0}};
    const clod_wall_locus_point bent[] = {{.sigma = 1e3, .tau = 100.0},
                                          {.sigma = 2e3, .tau = 900.0},
                                          {.sigma = 3e3, .tau = 500.0}};
    clod_wall_locus locus = evaluate(falls, 2);
    assert_non_null(strstr(locus.warnings[0], "falls while the normal stress rises"));
    clod_wall_locus_fini(&locus);
    locus = evaluate(below, 3);
    assert_int_equal(locus.warning_count, 1);
    assert_non_null(strstr(locus.warnings[0], "below 0, at -0.300 kPa"));
    clod_wall_locus_fini(&locus);
    locus = evaluate(bent, 3);
    assert_int_equal(locus.warning_count, 1);
    assert_non_null(strstr(locus.warnings[0], "do not lie on a line"));
    clod_wall_locus_fini(&locus);
}

// atan(-0.1): of a table; where all points tell the stress that was asked for they are of a simulation.
static void a_table_that_falls_is_refused(void **state)
{
    (void)state;
    clod_wall_locus_point points[] = {{.sigma = 1e3, .tau = 500.0},
                                      {.sigma = 2e3, .tau = 400.0}};
    clod_wall_locus locus;
    clod_status status = {0};
    assert_false(clod_wall_locus_of_table(points, 2, &locus, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_null(locus.marks);
    assert_non_null(
        strstr(status.text, "the wall yield locus falls: its line has phi_w = -5.7 deg."));
    points[0].wall_stress = 1e3;
    assert_false(clod_wall_locus_of_table(points, 2, &locus, &status));
    points[1].wall_stress = 2e3;
    assert_true(clod_wall_locus_of_table(points, 2, &locus, &status));
    assert_non_null(strstr(locus.warnings[0], "give more shear, more grains or more seeds"));
    clod_wall_locus_fini(&locus);
    points[1] = (clod_wall_locus_point){.sigma = 2e3, .tau = 500.0}; // flat
    assert_true(clod_wall_locus_of_table(points, 2, &locus, &status));
    clod_wall_locus_fini(&locus);
}

static void expect_only(const clod_wall_locus_point *points, size_t count, const char *text)
{
    clod_wall_locus locus = evaluate(points, count);
    assert_int_equal(locus.warning_count, text != NULL ? 1 : 0);
    if (text != NULL && strstr(locus.warnings[0], text) == NULL) {
        fail_msg("\"%s\" is not in \"%s\"", text, locus.warnings[0]);
    }
    clod_wall_locus_fini(&locus);
}

/** The how-to's table of steel, 14 deg, as it is; exchanged: atan(15/3.75) = 76 deg; with sigma_w
 *  1000 times as large: 0.014 deg. A sticky solid is steep at low stress only. */
static void an_angle_that_no_wall_has_is_told(void **state)
{
    (void)state;
    clod_wall_locus_point steel[] = {{.sigma = 5e3, .tau = 1.31e3},
                                     {.sigma = 10e3, .tau = 2.58e3},
                                     {.sigma = 20e3, .tau = 5.06e3}};
    expect_only(steel, 3, NULL);
    for (int k = 0; k < 3; k++) {
        const double sigma = steel[k].sigma;
        steel[k].sigma = steel[k].tau;
        steel[k].tau = sigma;
    }
    expect_only(steel, 3, "phi_w = 76.0 deg, and the shear stress is above the normal stress");
    for (int k = 0; k < 3; k++) {
        const double sigma = steel[k].tau;
        steel[k].tau = steel[k].sigma;
        steel[k].sigma = 1e3 * sigma;
    }
    expect_only(steel, 3, "phi_w = 0.014 deg: no wall is as smooth");
    const clod_wall_locus_point sticky[] = {{.sigma = 500.0, .tau = 1.2e3},
                                            {.sigma = 5e3, .tau = 3e3},
                                            {.sigma = 10e3, .tau = 5e3}};
    expect_only(sticky, 3, NULL);
}

/** 0.4 rad and 0.38 under deg, by hand; and 75 deg, from a table without tau_w. */
static void angles_of_a_table_that_no_wall_has(void **state)
{
    (void)state;
    clod_wall_locus_point wall[] = {{.sigma = 5e3, .tau = 34.9, .of_angle = true},
                                    {.sigma = 10e3, .tau = 66.3, .of_angle = true}};
    expect_only(wall, 2,
                "no wall is as smooth. Has phi_x another unit, rad under a header in deg");
    wall[0].tau = 18.66e3;
    wall[1].tau = 37.32e3;
    expect_only(wall, 2, "no wall is as rough. Has phi_x another unit");
}

/** A simulation has no columns to exchange and no units to mistake: what else it may be is said. */
static void an_angle_that_no_simulated_wall_has(void **state)
{
    (void)state;
    static const struct {
        double tau[3];
        const char *text;
    } CASES[] = {{{900.0, 700.0, 500.0}, "Was shear steady at each point?"},
                 {{2e3, 8e3, 14e3}, "no wall is as rough. Look at the plate"},
                 {{10.0, 20.0, 30.0}, "no wall is as smooth. Has the plate a friction"}};
    for (size_t k = 0; k < sizeof CASES / sizeof *CASES; k++) {
        clod_wall_locus_point points[3];
        for (int i = 0; i < 3; i++) {
            const double sigma = 2e3 * (double)(i + 1);
            points[i] = (clod_wall_locus_point){
                .sigma = sigma, .tau = CASES[k].tau[i], .wall_stress = sigma};
        }
        clod_wall_locus locus = evaluate(points, 3);
        assert_non_null(strstr(locus.warnings[0], CASES[k].text));
        assert_null(strstr(locus.warnings[0], "column"));
        clod_wall_locus_fini(&locus);
        points[1].wall_stress = 0.0; // a table
        locus = evaluate(points, 3);
        assert_non_null(strstr(locus.warnings[0], "column"));
        clod_wall_locus_fini(&locus);
    }
}

/** 30 kPa for 3 kPa; an error of the normal stress; one that is just smaller says nothing. A simulated plate without friction may have
 *  any. */
static void a_stated_error_as_large_as_its_value_is_told(void **state)
{
    (void)state;
    clod_wall_locus_point points[] = {{.sigma = 5e3, .tau = 1.5e3, .tau_error = 1.4e3},
                                      {.sigma = 10e3, .tau = 3e3, .tau_error = 2.9e3}};
    expect_only(points, 2, NULL);
    points[1].tau_error = 30e3;
    expect_only(points, 2,
                "tau_w is 3.000 kPa with a stated standard error of 30.000 kPa: nothing was "
                "measured then");
    points[1].tau_error = 0.0;
    points[0].sigma_error = 5e3;
    expect_only(points, 2, "sigma_w is 5.000 kPa with a stated standard error of 5.000 kPa");
    points[0].wall_stress = points[0].sigma;
    points[1].wall_stress = points[1].sigma;
    expect_only(points, 2, NULL);
}

/** In the text, the JSON and the CSV too, where the stress that was asked for is, if it is stated. */
static void what_was_not_steady_is_marked(void **state)
{
    (void)state;
    const clod_wall_locus_point points[] = {{.sigma = 1e3, .tau = 300.0, .unsteady = true},
                                            {.sigma = 2e3, .tau = 590.0, .wall_stress = 2e3},
                                            {.sigma = 3e3, .tau = 900.0}};
    expect_only(points, 3, "1 of 3 points was not steady");
    clod_wall_locus locus = evaluate(points, 3);
    char *table = clod_wall_locus_table(&locus);
    char *csv = clod_wall_locus_csv(&locus);
    char *json = clod_wall_locus_json(&locus);
    assert_non_null(strstr(table, "0.297  not steady\n"));
    assert_non_null(strstr(csv, ",wall_stress [Pa],steady [1]\n"));
    assert_non_null(strstr(csv, ",2000,1\n"));
    assert_non_null(strstr(csv, ",,0\n"));
    assert_non_null(strstr(json, "\"steady\": false"));
    assert_non_null(strstr(json, "\"wall_stress_Pa\": 2000.0"));
    assert_non_null(strstr(json, "\"wall_stress_Pa\": null"));
    clod_locus_free(table);
    clod_locus_free(csv);
    clod_locus_free(json);
    clod_wall_locus_fini(&locus);
}

/** An error below the digits of the table is not 0: 0.2 Pa; at 4 kPa 0.003 deg. */
static void a_small_error_is_no_zero(void **state)
{
    (void)state;
    const clod_wall_locus_point points[] = {{.sigma = 1e3, .tau = 300.0, .tau_error = 0.2},
                                            {.sigma = 4e3, .tau = 1200.0, .tau_error = 0.2}};
    clod_wall_locus locus = evaluate(points, 2);
    char *table = clod_wall_locus_table(&locus);
    assert_non_null(strstr(table, "4.000     1.200 ± <0.001     16.70 ± <0.01"));
    assert_null(strstr(table, "± 0.00"));
    assert_null(strstr(table, "±  0.00"));
    clod_locus_free(table);
    clod_wall_locus_fini(&locus);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_through_one_test_has_the_errors_of_its_scatter),
        cmocka_unit_test(stated_errors_carry_over),
        cmocka_unit_test(seeds_give_their_mean_and_scatter),
        cmocka_unit_test(what_is_no_locus_is_refused),
        cmocka_unit_test(a_locus_that_is_odd_says_so),
        cmocka_unit_test(a_table_that_falls_is_refused),
        cmocka_unit_test(an_angle_that_no_wall_has_is_told),
        cmocka_unit_test(angles_of_a_table_that_no_wall_has),
        cmocka_unit_test(an_angle_that_no_simulated_wall_has),
        cmocka_unit_test(a_stated_error_as_large_as_its_value_is_told),
        cmocka_unit_test(a_small_error_is_no_zero),
        cmocka_unit_test(what_was_not_steady_is_marked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
