// Classes of times against their definition, quantiles against distributions known by hand.

#include "state/time_class.h"
#include "support/check.h"

/** 240 a decade: edges are powers of 10^(1/240), and no class is wider than 1 %. */
static void edges(void **unused)
{
    (void)unused;
    check_relative(clod_time_class_from(0), 1e-3, 1e-15);
    check_relative(clod_time_class_from(240), 1e-2, 1e-13);
    check_relative(clod_time_class_from(CLOD_TIME_CLASSES), 1e6, 1e-12);
    for (int k = 0; k < CLOD_TIME_CLASSES; k++) {
        const double from = clod_time_class_from(k), to = clod_time_class_from(k + 1);
        assert_true(to / from > 1.0 && to / from < 1.01);
        assert_int_equal(clod_time_class(sqrt(from * to)), k);
    }
    assert_int_equal(clod_time_class(0.0), 0);
    assert_int_equal(clod_time_class(1e-9), 0);
    assert_int_equal(clod_time_class(1e9), CLOD_TIME_CLASSES - 1);
}

static void one_time_is_every_quantile(void **unused)
{
    (void)unused;
    const double time = 1.653, range[2] = {time, time};
    int64_t count[CLOD_TIME_CLASSES] = {0};
    count[clod_time_class(time)] = 1;
    for (double f = 0.0; f <= 1.0; f += 0.1) {
        assert_true(clod_time_class_quantile(count, 1, f, range) == time);
    }
}

/** Times 2.00, 2.01 ... 2.99 s: the quantile of f is 2 + f, to a class and to one of them. */
static void uniform_times(void **unused)
{
    (void)unused;
    const double range[2] = {2.0, 2.99};
    int64_t count[CLOD_TIME_CLASSES] = {0};
    for (int k = 0; k < 100; k++) {
        count[clod_time_class(2.0 + 0.01 * k)]++;
    }
    for (int k = 1; k < 10; k++) {
        const double expected = 2.0 + 0.1 * k;
        check_relative(clod_time_class_quantile(count, 100, 0.1 * k, range), expected, 0.01);
    }
    assert_true(clod_time_class_quantile(count, 100, 0.0, range) == 2.0);
    assert_true(clod_time_class_quantile(count, 100, 1.0, range) == 2.99);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edges),
        cmocka_unit_test(one_time_is_every_quantile),
        cmocka_unit_test(uniform_times),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
