// How points weigh in the line of a flow function, and whether it fits them: worked out by hand.

#include "hopper/chance.h"
#include "hopper/line_fit.h"
#include "support/check.h"

static clod_curve line(clod_curve_point *points, size_t count)
{
    return (clod_curve){.way = CLOD_CURVE_LINE, .points = points, .count = count};
}

/** Tables of chi-square and of F: what 5, 1 and 50 % lie above. */
static void chances_are_those_of_tables(void **state)
{
    (void)state;
    const struct {
        double chi_square;
        size_t freedom, errors;
        double chance;
    } of[] = {{3.8415, 1, 0, 0.05},     {5.9915, 2, 0, 0.05},    {7.8147, 3, 0, 0.05},
              {9.4877, 4, 0, 0.05},     {11.0705, 5, 0, 0.05},   {15.0863, 5, 0, 0.01},
              {5.3481, 6, 0, 0.5},      {18.513, 1, 2, 0.05},    {10.128, 1, 3, 0.05},
              {5.591, 1, 7, 0.05},      {2 * 9.552, 2, 3, 0.05}, {2 * 4.737, 2, 7, 0.05},
              {3 * 19.164, 3, 2, 0.05}, {5 * 5.050, 5, 5, 0.05}, {5.0, 5, 5, 0.5}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        check_relative(clod_chance_above(of[k].chi_square, of[k].freedom, of[k].errors),
                       of[k].chance, 1e-3);
    }
    check_close(clod_chance_above(0.0, 3, 0), 1.0, 1e-15);
    check_close(clod_chance_above(0.0, 3, 2), 1.0, 1e-15);
    assert_true(clod_chance_above(400.0, 2, 0) < 1e-80);
}

/** Of weights 1, 4, 1 at x = 0, 1, 2 with y = 0, 3, 3: mean y (0 + 12 + 3)/6 = 2.5 at x = 1, slope 6/4 (the one
 *  in the middle has none); off by -1, 0.5, -1 times sqrt(weight): chi-square 1 + 1 + 1 = 3 of 1 degree. */
static void points_weigh_by_their_errors(void **state)
{
    (void)state;
    clod_curve_point points[] = {{.x = 0.0, .y = 0.0, .y_error = 1.0},
                                 {.x = 1.0, .y = 3.0, .y_error = 0.5},
                                 {.x = 2.0, .y = 3.0, .y_error = 1.0}};
    clod_curve curve = line(points, 3);
    clod_line_fit_weigh(&curve);
    assert_true(curve.misfit.weighted);
    check_relative(curve.misfit.line.b, 1.5, 1e-14);
    check_relative(curve.misfit.line.a, 1.0, 1e-14);
    check_relative(curve.misfit.chi_square, 3.0, 1e-13);
    assert_int_equal(curve.misfit.freedom, 1);
    check_close(curve.misfit.chance, 0.0833, 1e-4); // 2 (1 - Phi(sqrt(3)))
    check_relative(curve.misfit.stretch, sqrt(3.0), 1e-13);
    assert_false(clod_line_fit_misses(&curve.misfit));
    points[1].y_error = 0.4;
    clod_line_fit_weigh(&curve);
    assert_true(curve.misfit.chi_square > 3.0);
}

/** The same errors along x, with a slope of 1.5, are 1.5 times as large across the line; together with y a point's
 *  error is sqrt(y^2 + b^2 x^2 - 2 b xy). */
static void errors_across_the_line_count(void **state)
{
    (void)state;
    clod_curve_point along[] = {{.x = 0.0, .y = 0.0, .y_error = 1e-9, .x_error = 1.0},
                                {.x = 1.0, .y = 3.0, .y_error = 1e-9, .x_error = 0.5},
                                {.x = 2.0, .y = 3.0, .y_error = 1e-9, .x_error = 1.0}};
    clod_curve curve = line(along, 3);
    clod_line_fit_weigh(&curve);
    check_relative(curve.misfit.line.b, 1.5, 1e-9);
    check_relative(curve.misfit.chi_square, 3.0 / 2.25, 1e-9);
    const clod_curve_point joint = {
        .x_error = 2.0, .y_error = 5.0, .joint = true, .part = {3.0, 4.0, 0.0, 0.0}};
    check_relative(clod_line_fit_error(&curve, &joint, 0.5), sqrt(25.0 + 1.0 - 6.0), 1e-14);
    const double spread[] = {3.0, -4.0}, x_spread[] = {-1.0, 1.0};
    const clod_curve shared = {.specimens = 2};
    const clod_curve_point point = {
        .x_error = sqrt(2.0), .y_error = 5.0, .spread = spread, .x_spread = x_spread};
    check_relative(clod_line_fit_error(&shared, &point, 0.5), sqrt(25.0 + 0.5 + 7.0), 1e-14);
}

/** Without an error at one point, and of specimens, all points weigh alike: through 0, 3, 3 goes 0.5 + 1.5 x. */
static void else_points_weigh_alike(void **state)
{
    (void)state;
    clod_curve_point points[] = {{.x = 0.0, .y = 0.0, .y_error = 1.0},
                                 {.x = 1.0, .y = 3.0},
                                 {.x = 2.0, .y = 3.0, .y_error = 1.0}};
    clod_curve curve = line(points, 3);
    clod_line_fit_weigh(&curve);
    assert_false(curve.misfit.weighted);
    check_relative(curve.misfit.line.a, 0.5, 1e-14);
    assert_true(isnan(curve.misfit.chi_square) && curve.misfit.stretch == 1.0);
    points[1].y_error = 0.5;
    for (int i = 0; i < 3; i++) {
        points[i].freedom = 2;
    }
    clod_line_fit_weigh(&curve);
    assert_false(curve.misfit.weighted);
    check_relative(curve.misfit.line.a, 0.5, 1e-14);
    // off by -0.5, 1, -0.5 of 1, 0.5, 1: F(1, 2) of 4.5 is no chance of 5 %, and errors stay
    check_relative(curve.misfit.chi_square, 4.5, 1e-13);
    assert_true(curve.misfit.stretch == 1.0 && !clod_line_fit_misses(&curve.misfit));
    for (int i = 0; i < 3; i++) {
        points[i].freedom = 0;
        points[i].unsure = i == 1;
    }
    clod_line_fit_weigh(&curve); // chi-square of 4.5 all the same
    assert_true(curve.misfit.unsure && !curve.misfit.weighted);
    check_relative(curve.misfit.stretch, sqrt(4.5), 1e-13);
    for (int i = 0; i < 3; i++) {
        points[i].freedom = 2;
        points[i].unsure = false;
    }
    points[1].y_error = 0.1; // F = 0.25 + 100 + 0.25
    clod_line_fit_weigh(&curve);
    assert_true(clod_line_fit_misses(&curve.misfit));
    check_relative(curve.misfit.stretch, sqrt(100.5), 1e-13);
}

/** Two points leave nothing to compare, and a curve from point to point is looked at by nobody. */
static void what_is_not_looked_at(void **state)
{
    (void)state;
    clod_curve_point points[] = {{.x = 0.0, .y = 0.0, .y_error = 1.0},
                                 {.x = 1.0, .y = 3.0, .y_error = 2.0},
                                 {.x = 2.0, .y = 3.0, .y_error = 1.0}};
    clod_curve two = line(points, 2);
    clod_line_fit_weigh(&two);
    assert_true(two.misfit.stretch == 1.0 && two.misfit.freedom == 0);
    check_relative(two.misfit.line.b, 3.0, 1e-14);
    clod_curve extended = {.way = CLOD_CURVE_EXTENDED, .points = points, .count = 3};
    clod_line_fit_weigh(&extended);
    assert_true(extended.misfit.stretch == 0.0);
    check_relative(clod_curve_at(&extended, 1.5), 3.0, 1e-14);
}

/** Twice as far from the measured line as the points say: 2.5 + (4 - 2.5) 2 in the middle for y + 1.5. */
static void a_misfit_stretches_the_line(void **state)
{
    (void)state;
    clod_curve_point points[] = {{.x = 0.0, .y = 0.0, .y_error = 1.0},
                                 {.x = 1.0, .y = 3.0, .y_error = 0.5},
                                 {.x = 2.0, .y = 3.0, .y_error = 1.0}};
    clod_curve curve = line(points, 3);
    clod_line_fit_weigh(&curve);
    curve.misfit.stretch = 2.0;
    check_relative(clod_curve_at(&curve, 1.0), 2.5, 1e-14);
    for (int i = 0; i < 3; i++) {
        points[i].y += 1.5;
    }
    check_relative(clod_curve_at(&curve, 1.0), 5.5, 1e-14);
    check_relative(clod_curve_fit(&curve).b, 1.5, 1e-13);
    points[2].y += 1.0; // slope by 0.5, the middle by 1/6
    check_relative(clod_curve_fit(&curve).b, 1.5 + 2.0 * 0.5, 1e-13);
    check_relative(clod_curve_at(&curve, 1.0), 5.5 + 2.0 / 6.0, 1e-13);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chances_are_those_of_tables),
        cmocka_unit_test(points_weigh_by_their_errors),
        cmocka_unit_test(errors_across_the_line_count),
        cmocka_unit_test(else_points_weigh_alike),
        cmocka_unit_test(what_is_not_looked_at),
        cmocka_unit_test(a_misfit_stretches_the_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
