// Mean of measurements: value and standard error by hand.

#include "analysis/mean.h"
#include "support/check.h"

/** 2, 4, 6, 8: mean 5, squares 9 + 1 + 1 + 9 = 20, so s^2 = 20/3 and the error sqrt(20/3/4). */
static void values_without_stated_errors_have_that_of_their_scatter(void **state)
{
    (void)state;
    const double value[] = {2.0, 4.0, 6.0, 8.0};
    const clod_locus_value mean = clod_mean_of(value, 4, 0.0);
    check_relative(mean.value, 5.0, 1e-15);
    check_relative(mean.error, sqrt(5.0 / 3.0), 1e-15);
    assert_true(isnan(mean.scatter));
}

/** Stated 3 and 4: sqrt(9 + 16)/2 = 2.5. The scatter of 1 and 7 is 3, that of 3 and 5 is 1. */
static void error_is_the_larger_of_the_stated_and_that_of_the_scatter(void **state)
{
    (void)state;
    const double wide[] = {1.0, 7.0};
    const double close[] = {3.0, 5.0};
    check_relative(clod_mean_of(wide, 2, 25.0).error, 3.0, 1e-15);
    check_relative(clod_mean_of(close, 2, 25.0).error, 2.5, 1e-15);
}

static void single_value_has_its_stated_error_or_none(void **state)
{
    (void)state;
    const double one[] = {7.0};
    assert_true(clod_mean_of(one, 1, 0.25).value == 7.0);
    assert_true(clod_mean_of(one, 1, 0.25).error == 0.5);
    assert_true(isnan(clod_mean_of(one, 1, 0.0).error));
    assert_true(isnan(clod_mean_of(one, 0, 0.0).value));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_without_stated_errors_have_that_of_their_scatter),
        cmocka_unit_test(error_is_the_larger_of_the_stated_and_that_of_the_scatter),
        cmocka_unit_test(single_value_has_its_stated_error_or_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
