/**
 * Whether a budget is too small for an estimate: five points of 10 s take 50 s.
 */

#include "calibrate/estimate.h"
#include "plan_made.h"
#include "support/check.h"

static const char *said(double budget, bool *hopeless)
{
    static char text[512];
    plan_made made;
    plan_make(&made, 1, 1);
    made.plan.points = 0;
    made.plan.budget = budget;
    const clod_estimate estimate = {.each = 10.0, .points = budget / 10.0, .least = 5};
    clod_estimate_text(&estimate, &made.plan, 2, text, sizeof text);
    *hopeless = clod_estimate_hopeless(&estimate, &made.plan);
    return text;
}

static void a_budget_that_is_too_small(void **state)
{
    (void)state;
    bool hopeless;
    assert_non_null(strstr(said(51.0, &hopeless), "about 5 points fit the budget of 51 s"));
    assert_null(strstr(said(51.0, &hopeless), "too small"));
    assert_false(hopeless);
    assert_true(
        strncmp(said(30.0, &hopeless), "WARNING: the budget of 30 s looks too small", 43) == 0);
    assert_false(hopeless);
    (void)said(17.0, &hopeless); // a third of 50 s is 16.7
    assert_false(hopeless);
    assert_true(strncmp(said(10.0, &hopeless), "the budget of 10 s looks too small", 34) == 0);
    assert_true(hopeless);
    (void)said(16.0, &hopeless);
    assert_true(hopeless);
}

static void given_points_need_no_budget(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 1, 1); // 24 points, no budget
    const clod_estimate estimate = {.each = 10.0, .points = 24.0, .least = 5};
    assert_false(clod_estimate_hopeless(&estimate, &made.plan));
}

static void a_budget_buys_256_points_at_most(void **state)
{
    (void)state;
    char text[512];
    plan_made made;
    plan_make(&made, 3, 1);
    made.plan.points = 0;
    made.plan.budget = 3600.0;
    assert_true(clod_estimate_points(&made.plan, 15.0) == 240.0);
    assert_true(clod_estimate_points(&made.plan, 16.1) == 223.0);
    assert_true(clod_estimate_points(&made.plan, 0.17) == 256.0);
    const clod_estimate estimate = {.each = 0.125, .points = 256.0, .least = 9, .fits = 20.0};
    clod_estimate_text(&estimate, &made.plan, 2, text, sizeof text);
    assert_non_null(strstr(
        text, ": a budget buys 256 points at most, which take 32 s of its 60 min. More seeds"));
}

// Table of docs/theory/calibration.md: seconds of one fit of one target. A whole calibration makes four, of 6, 7, 8 and 9 ninths
// of the points.
static void fits_take_what_the_table_has(void **state)
{
    (void)state;
    static const struct {
        size_t parameters;
        double points, seconds;
    } MEASURED[] = {
        {1, 24, 0.17}, {2, 100, 1.7}, {2, 200, 5.3}, {4, 200, 11.0}, {2, 400, 30.0}};
    for (size_t k = 0; k < sizeof MEASURED / sizeof *MEASURED; k++) {
        plan_made made;
        plan_make(&made, MEASURED[k].parameters, 3);
        const double all = clod_estimate_fits(&made.plan, MEASURED[k].points);
        // between 4 times (6/9)^3 and 4 times the last one, of each of three targets
        assert_true(all > 3.0 * 4.0 * 0.296 * MEASURED[k].seconds);
        assert_true(all < 3.0 * 4.0 * MEASURED[k].seconds);
    }
}

static void fits_that_take_long_are_told(void **state)
{
    (void)state;
    char text[512];
    plan_made made;
    plan_make(&made, 1, 1); // 24 points: 240 s of runs
    clod_estimate estimate = {.each = 10.0, .points = 24.0, .least = 5, .fits = 31.0};
    clod_estimate_text(&estimate, &made.plan, 2, text, sizeof text);
    assert_non_null(strstr(text, "24 points 240 s; the fits behind them take some 31 s more"));
    estimate.fits = 29.0;
    clod_estimate_text(&estimate, &made.plan, 2, text, sizeof text);
    assert_null(strstr(text, "fits"));
    estimate = (clod_estimate){.each = 100.0, .points = 24.0, .least = 5, .fits = 239.0};
    clod_estimate_text(&estimate, &made.plan, 2, text, sizeof text);
    assert_null(strstr(text, "fits"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_budget_that_is_too_small),
        cmocka_unit_test(a_budget_buys_256_points_at_most),
        cmocka_unit_test(fits_take_what_the_table_has),
        cmocka_unit_test(fits_that_take_long_are_told),
        cmocka_unit_test(given_points_need_no_budget),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
