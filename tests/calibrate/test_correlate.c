/**
 * Correlations from few residuals. Expected: by hand.
 */

#include "calibrate/correlate.h"

#include <math.h>
#include <string.h>

#include "support/check.h"

static const double NONE = (double)NAN;

/** Of three rows about their mean two degrees are left; the third number is the second turned round. */
static void numbers_that_move_together_are_seen(void **state)
{
    (void)state;
    const double rows[] = {1, 2, -2, -1, -2, 2, 0, 0, 0};
    const clod_correlate_rows of = {.values = rows, .rows = 3, .count = 3, .block = 3};
    double r[9];
    check_close(clod_correlate(&of, r), 2.0, 1e-12);
    check_close(r[1], 1.0, 1e-12);
    check_close(r[2], -1.0, 1e-12);
    check_close(r[5], -1.0, 1e-12);
    check_close(r[7], -1.0, 1e-12);
    check_close(r[4], 1.0, 1e-12);
}

/** Two points of two packings each: one degree a point. Products 1 - 4 + 1 - 4 = -6, squares 4 and 34. */
static void each_point_loses_its_mean(void **state)
{
    (void)state;
    const double rows[] = {1, 1, -1, -1, 1, -4, -1, 4};
    const clod_correlate_rows of = {.values = rows, .rows = 4, .count = 2, .block = 2};
    double r[4];
    check_close(clod_correlate(&of, r), 2.0, 1e-12);
    check_close(r[1], -6.0 / sqrt(4.0 * 34.0), 1e-12);
    const clod_correlate_rows fitted = {
        .values = rows, .rows = 4, .count = 2, .block = 4, .lost = 3};
    check_close(clod_correlate(&fitted, r), 1.0, 1e-12);
}

/** A row that one of them lacks is no row; without a row nothing is told. */
static void missing_rows_are_left_out(void **state)
{
    (void)state;
    const double rows[] = {1, 1, 5, NONE, -1, 1, NONE, 7, 2, 2, -2, -2};
    const clod_correlate_rows of = {.values = rows, .rows = 6, .count = 2, .block = 6};
    double r[4];
    check_close(clod_correlate(&of, r), 3.0,
                1e-12); // rows 0, 2, 4, 5: 1 - 1 + 4 + 4 = 8, squares 10
    check_close(r[1], 0.8, 1e-12);
    const double apart[] = {1, NONE, -1, NONE, NONE, 1, NONE, -1};
    const clod_correlate_rows none = {.values = apart, .rows = 4, .count = 2, .block = 4};
    check_close(clod_correlate(&none, r), 0.0, 0.0);
    check_close(r[1], 0.0, 0.0);
    check_close(r[3], 1.0, 0.0);
}

/** Numbers 0 and 1 have rows 0 to 2 in common, number 2 has one with neither. */
static void pairs_that_are_not_told_are_completed(void **state)
{
    (void)state;
    const double rows[] = {1, 2, NONE, -1, -2, NONE, 0, 0, NONE, NONE, NONE, 4};
    const clod_correlate_rows of = {.values = rows, .rows = 4, .count = 3, .block = 4};
    double r[9];
    check_close(clod_correlate(&of, r), 2.0, 1e-12);
    check_close(r[1], 1.0, 1e-12);
    assert_true(isnan(r[2]) && isnan(r[5]) && isnan(r[6]) && isnan(r[7]));
    double alike[9];
    memcpy(alike, r, sizeof r);
    clod_correlate_complete(alike, NULL, 3);
    check_close(alike[2], 1.0, 1e-12); // the mean of the one that is told
    const double other[] = {1, 0.1, 0.2, 0.1, 1, 0.3, 0.2, 0.3, 1};
    clod_correlate_complete(r, other, 3);
    check_close(r[1], 1.0, 1e-12);
    check_close(r[5], 0.3, 1e-12);
    check_close(r[6], 0.2, 1e-12);
    double against[] = {1, -0.5, NONE, -0.5, 1, NONE, NONE, NONE, 1};
    clod_correlate_complete(against, NULL, 3);
    check_close(against[7], 0.0, 0.0);
}

/** Squares beyond the largest number tell nothing. */
static void numbers_that_overflow_are_not_told(void **state)
{
    (void)state;
    const double rows[] = {1e200, 1e200, -1e200, -1e200, 1e200, -1e200};
    const clod_correlate_rows of = {.values = rows, .rows = 3, .count = 2, .block = 3};
    double r[4];
    check_close(clod_correlate(&of, r), 0.0, 0.0);
    check_close(r[1], 0.0, 0.0);
}

static void two_estimates_are_weighted_by_their_degrees(void **state)
{
    (void)state;
    double r[] = {1, 0.9, 0.9, 1};
    const double other[] = {1, 0.1, 0.1, 1};
    check_close(clod_correlate_join(r, 2.0, other, 6.0, 2), 8.0, 1e-12);
    check_close(r[1], 0.3, 1e-12); // (1.8 + 0.6)/8
    check_close(r[0], 1.0, 1e-12);
}

static void few_residuals_are_drawn_towards_equal_correlations(void **state)
{
    (void)state;
    double two[] = {1, 0.8, 0.8, 1}; // c = 0.8 4/5 = 0.64; (4 0.8 + 2 0.64)/6
    clod_correlate_shrink(two, 2, 4.0);
    check_close(two[1], 4.48 / 6.0, 1e-12);
    double against[] = {1, -0.6, -0.6, 1}; // c = 0: 4 (-0.6)/6
    clod_correlate_shrink(against, 2, 4.0);
    check_close(against[2], -0.4, 1e-12);
    double nothing[] = {1, 0, 0, 1};
    clod_correlate_shrink(nothing, 2, 0.0);
    check_close(nothing[1], 0.0, 0.0);
    double one[] = {1, 1, 1, 1, 1, 1, 1, 1, 1}; // c = 2/3: (2 + 3 2/3)/5; singular before
    clod_correlate_shrink(one, 3, 2.0);
    check_close(one[1], 0.8, 1e-12);
    check_close(one[4], 1.0, 0.0);
    assert_true(isfinite(clod_correlate_factor(one, 3)));
}

/** Variances of independent numbers add their degrees, those of one number do not; of two with r = 0.5 it is
 *  2 4/(2 + 2 0.25). */
static void degrees_of_pooled_variances(void **state)
{
    (void)state;
    const double apart[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double one[] = {1, 1, 1, 1, 1, 1, 1, 1, 1};
    const double half[] = {1, 0.5, 0.5, 1};
    check_close(clod_correlate_pooled(apart, 3, 2.0), 6.0, 1e-12);
    check_close(clod_correlate_pooled(one, 3, 2.0), 2.0, 1e-12);
    check_close(clod_correlate_pooled(half, 2, 2.0), 3.2, 1e-12);
}

/** (4 2; 2 5) = L L' with L = (2 0; 1 2), determinant 16; L^-1 (2, 3) = (1, 1). */
static void factor_and_distance(void **state)
{
    (void)state;
    double v[] = {4, 2, 2, 5};
    double x[] = {2, 3};
    check_close(clod_correlate_factor(v, 2), log(16.0), 1e-12);
    check_close(clod_correlate_distance(v, 2, x), 2.0, 1e-12);
    double bad[] = {1, 2, 2, 1};
    assert_true(isnan(clod_correlate_factor(bad, 2)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_that_move_together_are_seen),
        cmocka_unit_test(each_point_loses_its_mean),
        cmocka_unit_test(missing_rows_are_left_out),
        cmocka_unit_test(pairs_that_are_not_told_are_completed),
        cmocka_unit_test(numbers_that_overflow_are_not_told),
        cmocka_unit_test(two_estimates_are_weighted_by_their_degrees),
        cmocka_unit_test(few_residuals_are_drawn_towards_equal_correlations),
        cmocka_unit_test(degrees_of_pooled_variances),
        cmocka_unit_test(factor_and_distance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
