// The straight line of least squares, on points worked out by hand.

#include "analysis/fit.h"
#include "support/check.h"

/**
 * Means 1.5 and 1, sums of products 5 and 3: slope 0.6, intercept 0.1; off the line by -0.1,
 * 0.3, -0.3, 0.1: sum of squares 0.2; standard error sqrt(0.2/2/5).
 */
static void a_line_and_the_error_of_its_slope_match_hand_calculation(void **state)
{
    (void)state;
    const double x[] = {0.0, 1.0, 2.0, 3.0};
    const double y[] = {0.0, 1.0, 1.0, 2.0};
    const clod_fit line = clod_fit_line(x, y, 4);
    check_close(line.slope, 0.6, 1e-15);
    check_close(line.intercept, 0.1, 1e-15);
    check_close(line.residual, 0.2, 1e-15);
    check_relative(clod_fit_slope_error(&line, 4), sqrt(0.02), 1e-14);
}

/**
 * The same points. Without stated errors the scatter 0.2/2 counts: slope sqrt(0.1/5), intercept
 * sqrt(0.1 (1/4 + 1.5^2/5)). Stated variances of 0.4 have more than the scatter: sqrt(0.4/5).
 */
static void errors_are_stated_or_of_the_scatter(void **state)
{
    (void)state;
    const double x[] = {0.0, 1.0, 2.0, 3.0};
    const double y[] = {0.0, 1.0, 1.0, 2.0};
    const double none[] = {0.0, 0.0, 0.0, 0.0};
    const double large[] = {0.4, 0.4, 0.4, 0.4};
    const clod_fit line = clod_fit_line(x, y, 4);
    const clod_fit_error scatter = clod_fit_errors(&line, x, none, 4);
    check_relative(scatter.slope, sqrt(0.02), 1e-14);
    check_relative(scatter.intercept, sqrt(0.07), 1e-14);
    check_relative(clod_fit_errors(&line, x, large, 4).slope, sqrt(0.08), 1e-14);
    const clod_fit two = clod_fit_line(x, y, 2);
    assert_false(clod_fit_errors(&two, x, none, 2).known);
    assert_true(isnan(clod_fit_errors(&two, x, none, 2).slope));
    check_relative(clod_fit_errors(&two, x, large, 2).slope, sqrt(0.8), 1e-14);
}

/** On the line there is no scatter: the slope is certain. */
static void points_on_a_line_have_no_error(void **state)
{
    (void)state;
    const double x[] = {0.0, 1.0, 2.0};
    const double y[] = {1.0, 3.0, 5.0};
    const clod_fit line = clod_fit_line(x, y, 3);
    check_close(clod_fit_slope_error(&line, 3), 0.0, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_and_the_error_of_its_slope_match_hand_calculation),
        cmocka_unit_test(errors_are_stated_or_of_the_scatter),
        cmocka_unit_test(points_on_a_line_have_no_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
