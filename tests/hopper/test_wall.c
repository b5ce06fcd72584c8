// Means of wall friction points of several specimens, and what they share: worked out by hand.

#include "hopper/wall.h"

#include <string.h>

#include "support/check.h"

static clod_warning_list warnings;

static clod_curve curve_of(const clod_wall_locus_point *points, size_t count)
{
    clod_curve curve;
    clod_status status = {0};
    warnings.count = 0;
    if (!clod_wall_curve(points, count, &curve, &warnings, &status)) {
        fail_msg("%s", status.text);
    }
    return curve;
}

/** Two at 2 % apart are one, at their mean; errors of 0.2 and 0: of the mean sqrt(0.2^2)/2. The
 *  others scatter by 1 at one stress: standard error 0.5. */
static void repeats_at_one_stress_are_averaged(void **state)
{
    (void)state;
    const clod_wall_locus_point points[] = {{.sigma = 4.0, .tau = 2.0},
                                            {.sigma = 100.0, .tau = 31.0, .tau_error = 0.1},
                                            {.sigma = 4.08, .tau = 2.0, .tau_error = 0.2},
                                            {.sigma = 100.0, .tau = 30.0, .tau_error = 0.1}};
    clod_curve curve = curve_of(points, 4);
    assert_int_equal(curve.count, 2);
    assert_int_equal(curve.specimens, 0);
    check_close(curve.points[0].x, 4.04, 1e-13);
    check_close(curve.points[0].y_error, 0.1, 1e-13);
    check_close(curve.points[1].x, 100.0, 1e-12);
    check_close(curve.points[1].y, 30.5, 1e-12);
    check_close(curve.points[1].y_error, 0.5, 1e-12);
    assert_null(curve.points[1].spread);
    assert_int_equal(curve.points[0].freedom, 0); // its error is the stated one
    assert_int_equal(curve.points[1].freedom, 1); // two repeats
    clod_curve_fini(&curve);
}

/** Both seeds lie on tau = 0.2 sigma, at other normal stresses of the same programme: nothing is
 *  uncertain about the line. By their distance, 8 %, they would be two points. */
static void specimens_on_one_line_have_no_error(void **state)
{
    (void)state;
    const clod_wall_locus_point points[] = {
        {.seed = 1, .sigma = 19e3, .tau = 3.8e3, .wall_stress = 20e3},
        {.seed = 1, .sigma = 9e3, .tau = 1.8e3, .wall_stress = 10e3},
        {.seed = 2, .sigma = 17.5e3, .tau = 3.5e3, .wall_stress = 20e3},
        {.seed = 2, .sigma = 8.3e3, .tau = 1.66e3, .wall_stress = 10e3}};
    clod_curve curve = curve_of(points, 4);
    assert_int_equal(curve.count, 2);
    check_relative(curve.points[0].x, 8.65e3, 1e-12);
    check_relative(curve.points[1].y, 3.65e3, 1e-12);
    for (int k = 0; k < 2; k++) {
        check_close(curve.points[k].y_error, 0.0, 1e-9);
        assert_true(curve.points[k].x_error == 0.0);
    }
    assert_true(clod_curve_has_errors(&curve)); // that it is nothing, both of them tell
    clod_curve_fini(&curve);
}

/** Ratios 0.20 and 0.24 at both stresses, 1 and 2 kPa: off the mean by 20 and 40 Pa, which is also
 *  the standard error of the mean of two; spread: +-20/sqrt(2), +-40/sqrt(2). */
static void specimens_share_their_scatter(void **state)
{
    (void)state;
    const clod_wall_locus_point points[] = {{.seed = 7, .sigma = 1e3, .tau = 200.0},
                                            {.seed = 7, .sigma = 2e3, .tau = 400.0},
                                            {.seed = 9, .sigma = 1e3, .tau = 240.0},
                                            {.seed = 9, .sigma = 2e3, .tau = 480.0}};
    clod_curve curve = curve_of(points, 4);
    assert_int_equal(curve.specimens, 2);
    for (int k = 0; k < 2; k++) {
        const double off = k == 0 ? 20.0 : 40.0;
        check_relative(curve.points[k].y_error, off, 1e-9);
        check_relative(curve.points[k].spread[0], -off / sqrt(2.0), 1e-9);
        check_relative(curve.points[k].spread[1], off / sqrt(2.0), 1e-9);
    }
    clod_curve_fini(&curve);
}

/** tau = 100 Pa + 0.4 sigma at 1, 2, 3, 4 kPa, off it by 10, -10, -10, 10 Pa, which no line takes up: 4 x 10^2 with two
 *  degrees of freedom left: 14.1 Pa. A larger error that is stated for a point stays, a smaller one does not. */
static void points_without_errors_have_their_scatter(void **state)
{
    (void)state;
    const clod_wall_locus_point points[] = {{.sigma = 1e3, .tau = 510.0},
                                            {.sigma = 2e3, .tau = 890.0, .tau_error = 20.0},
                                            {.sigma = 3e3, .tau = 1290.0},
                                            {.sigma = 4e3, .tau = 1710.0, .tau_error = 7.0}};
    clod_curve curve = curve_of(points, 4);
    assert_int_equal(curve.count, 4);
    assert_true(clod_curve_has_errors(&curve));
    for (size_t i = 0; i < 4; i++) {
        const bool stated = i == 1;
        check_relative(curve.points[i].y_error, stated ? 20.0 : 10.0 * sqrt(2.0), 1e-9);
        assert_int_equal(curve.points[i].by_line > 0.0, !stated);
        assert_int_equal(curve.points[i].freedom, stated ? 0 : 2);
        assert_int_equal(curve.points[i].set, stated ? 1 : 0); // one scale for all of them
    }
    clod_curve_fini(&curve);
}

/** Two stresses, or points that lie on a line to the last digit, tell nothing. */
static void errors_that_nothing_tells_are_not_known(void **state)
{
    (void)state;
    const clod_wall_locus_point points[] = {{.sigma = 1e3, .tau = 440.0},
                                            {.sigma = 2e3, .tau = 830.0},
                                            {.sigma = 4e3, .tau = 1610.0}};
    for (size_t count = 2; count <= 3; count++) {
        clod_curve curve = curve_of(points, count);
        assert_int_equal(curve.count, count);
        assert_false(clod_curve_has_errors(&curve));
        assert_int_equal(warnings.count, 0); // nor are they called those of one specimen
        clod_curve_fini(&curve);
    }
}

static void what_the_evaluation_says_is_handed_on(void **state)
{
    (void)state;
    const clod_wall_locus_point bent[] = {{.sigma = 1e3, .tau = 100.0},
                                          {.sigma = 2e3, .tau = 900.0, .unsteady = true},
                                          {.sigma = 3e3, .tau = 500.0}};
    clod_curve curve = curve_of(bent, 3);
    assert_int_equal(warnings.count, 3);
    assert_non_null(strstr(warnings.text[0], "Wall yield locus: 1 of 3 points was not steady"));
    assert_non_null(strstr(warnings.text[1], "Wall yield locus: The points do not lie on"));
    assert_non_null(strstr(warnings.text[2], "Wall yield locus: errors of one specimen"));
    clod_curve_fini(&curve);
    curve = curve_of(bent, 1); // a line from the origin: no locus, but enough for a hopper
    assert_int_equal(curve.count, 1);
    assert_int_equal(warnings.count, 1);
    assert_non_null(strstr(warnings.text[0], "needs at least two points"));
    clod_curve_fini(&curve);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(repeats_at_one_stress_are_averaged),
        cmocka_unit_test(specimens_on_one_line_have_no_error),
        cmocka_unit_test(specimens_share_their_scatter),
        cmocka_unit_test(points_without_errors_have_their_scatter),
        cmocka_unit_test(errors_that_nothing_tells_are_not_known),
        cmocka_unit_test(what_the_evaluation_says_is_handed_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
