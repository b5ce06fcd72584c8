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
 *  degrees of freedom left: 14.1 Pa, which 7 Pa that are stated for a point are raised to. */
static void points_without_errors_have_their_scatter(void **state)
{
    (void)state;
    const clod_wall_locus_point points[] = {{.sigma = 1e3, .tau = 510.0},
                                            {.sigma = 2e3, .tau = 890.0, .tau_error = 7.0},
                                            {.sigma = 3e3, .tau = 1290.0},
                                            {.sigma = 4e3, .tau = 1710.0}};
    clod_curve curve = curve_of(points, 4);
    assert_int_equal(curve.count, 4);
    assert_true(clod_curve_has_errors(&curve));
    for (size_t i = 0; i < 4; i++) {
        const bool stated = i == 1;
        check_relative(curve.points[i].y_error, 10.0 * sqrt(2.0), 1e-9);
        check_close(clod_curve_stated(&curve.points[i]), stated ? 7.0 : 0.0, 1e-12);
        assert_int_equal(curve.points[i].by_line, !stated);
        assert_int_equal(curve.points[i].freedom, 2);
        assert_int_equal(curve.points[i].set, 0); // one scale for all of them
    }
    clod_curve_fini(&curve);
}

/** The same points, whose scatter is 14.1 Pa: errors stated too small, 1 and 3 Pa, keep their difference; 13 Pa are raised,
 *  by what chance may do (chi-square 400/169 of 2, p 0.31), and so stay known; 20 Pa explain the scatter. The error of
 *  phi_w is then that of clod locus. */
static void errors_stated_too_small_have_the_scatter_beyond_them(void **state)
{
    (void)state;
    static const double STATED[][2] = {{1.0, 3.0}, {13.0, 13.0}, {20.0, 20.0}};
    for (int k = 0; k < 3; k++) {
        const double *of = STATED[k];
        const clod_wall_locus_point points[] = {
            {.sigma = 1e3, .tau = 510.0, .tau_error = of[0]},
            {.sigma = 2e3, .tau = 890.0, .tau_error = of[0]},
            {.sigma = 3e3, .tau = 1290.0, .tau_error = of[1]},
            {.sigma = 4e3, .tau = 1710.0, .tau_error = of[1]}};
        clod_curve curve = curve_of(points, 4);
        clod_wall_locus locus;
        clod_status status = {0};
        assert_true(clod_wall_locus_evaluate(points, 4, &locus, &status));
        const double mean = 0.5 * (of[0] * of[0] + of[1] * of[1]);
        double slope = 0.0; // its variance: levers -1.5, -0.5, 0.5, 1.5 over 5 kPa
        for (int i = 0; i < 4; i++) {
            const double own = of[i / 2] * of[i / 2] + fmax(200.0 - mean, 0.0);
            check_relative(curve.points[i].y_error, sqrt(own), 1e-9);
            check_close(clod_curve_stated(&curve.points[i]), of[i / 2], 1e-12);
            assert_int_equal(curve.points[i].freedom, k == 0 ? 2 : 0);
            slope += own * pow((i - 1.5) / 5e3, 2.0);
        }
        const double tangent = tan(locus.phi_w.value);
        check_relative(locus.phi_w.error, sqrt(slope) / (1.0 + tangent * tangent), 1e-9);
        clod_wall_locus_fini(&locus);
        clod_curve_fini(&curve);
    }
}

/** The points of above, 14.1 Pa off their line; two tell nothing of tau. */
static void an_error_of_the_normal_stress_is_none_of_tau(void **state)
{
    (void)state;
    const clod_wall_locus_point points[] = {{.sigma = 1e3, .tau = 510.0, .sigma_error = 1.0},
                                            {.sigma = 2e3, .tau = 890.0, .sigma_error = 1.0},
                                            {.sigma = 3e3, .tau = 1290.0, .sigma_error = 1.0},
                                            {.sigma = 4e3, .tau = 1710.0, .sigma_error = 1.0}};
    clod_curve curve = curve_of(points, 4);
    for (int i = 0; i < 4; i++) {
        check_relative(curve.points[i].y_error, 10.0 * sqrt(2.0), 1e-9);
        assert_true(curve.points[i].by_line && curve.points[i].x_error == 1.0);
    }
    clod_curve_fini(&curve);
    curve = curve_of(points, 2);
    assert_false(clod_curve_has_errors(&curve));
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
        cmocka_unit_test(errors_stated_too_small_have_the_scatter_beyond_them),
        cmocka_unit_test(an_error_of_the_normal_stress_is_none_of_tau),
        cmocka_unit_test(errors_that_nothing_tells_are_not_known),
        cmocka_unit_test(what_the_evaluation_says_is_handed_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
