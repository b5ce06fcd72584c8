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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_budget_that_is_too_small),
        cmocka_unit_test(given_points_need_no_budget),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
