/**
 * Three shear points of few specimens that move together: 90 % intervals hold the truth in so many repeats that 0.9 is
 * not refuted. Asserted is that, were the share 0.9, so few or fewer would hold it in more than one of 1000 such tests:
 * 21 of 30 pass and 20 do not, 29 of 40 pass and 28 do not. So a test sees a share of a half, as it was with three
 * specimens and a correlation of 0.9 when errors were taken as independent and known. It misses one of 0.7 half of the
 * time, and mostly one of 0.8. test_coverage_specimens_slow.c has more of it: many specimens, and points that do not
 * move together. The width of an ideal interval: the mean of three numbers with noise s of specimens and a correlation r
 * has the error s sqrt((1 + 2 r)/3/n), over the slope 0.35; with runs that tell the function well, 3.29 of them.
 */

#include "coverage.h"

/** n = 3, r = 0.9: 0.05 sqrt(2.8/3/3) 0.35^-1 2 2.92/0.9 = 0.52 by Student's t of 2 degrees. */
static void few_specimens_that_move_together(void **state)
{
    (void)state;
    assert_true(coverage_holds(&(coverage){0.9, 3, 12, 30}, 0.55));
}

/** A line for a surrogate. */
static void few_points(void **state)
{
    (void)state;
    assert_true(coverage_holds(&(coverage){0.5, 3, 5, 40}, 0.6));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(few_specimens_that_move_together),
        cmocka_unit_test(few_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
