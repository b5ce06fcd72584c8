/**
 * As test_coverage_specimens.c, over correlations, specimens and points: docs/theory/calibration.md has the
 * table. Some sixteen minutes of processor time. The width of an ideal interval is as there.
 */

#include "coverage.h"

#define REPEATS 60

static void intervals_hold_the_truth_as_often_as_they_say(void **state)
{
    (void)state;
    static const double CORRELATIONS[] = {0.0, 0.5, 0.9};
    static const int SPECIMENS[] = {3, COVERAGE_SPECIMENS};
    static const int64_t POINTS[] = {5, 12, 24};
    for (size_t k = 0; k < 18; k++) {
        const coverage of = {CORRELATIONS[k / 6], SPECIMENS[k % 2], POINTS[k / 2 % 3], REPEATS};
        assert_true(coverage_holds(&of, 0.7));
    }
}

/** n = 24, r = 0.9: 0.05 sqrt(2.8/3/24) 3.29/0.35/0.9 = 0.10; the surrogate of 12 points adds as much again. */
static void many_specimens_that_move_together(void **state)
{
    (void)state;
    assert_true(coverage_holds(&(coverage){0.9, COVERAGE_SPECIMENS, 12, 30}, 0.4));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(many_specimens_that_move_together),
        cmocka_unit_test(intervals_hold_the_truth_as_often_as_they_say),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
