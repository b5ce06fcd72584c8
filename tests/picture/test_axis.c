/**
 * @file test_axis.c
 * Ranges, ticks and units of colour bars, by hand.
 */

#include "picture/axis.h"

#include <math.h>

#include "support/check.h"

static void check_range(double *value, size_t count, double min, double max)
{
    double low, high;
    clod_axis_range(value, count, &low, &high);
    check_close(low, min, 1e-9 * (max - min));
    check_close(high, max, 1e-9 * (max - min));
}

static void ranges_are_round(void **state)
{
    (void)state;
    check_range(NULL, 0, 0.0, 1.0);
    // 0.1 is below a quarter of 3.47: from zero; ticks at 0.5, ends at halves of these
    check_range((double[]){3.47, 0.1, 2.0}, 3, 0.0, 3.5);
    // both signs: zero in the middle
    check_range((double[]){-0.8, 1.9}, 2, -2.0, 2.0);
    // a few small backward ones do not matter; ends at quarters
    check_range((double[]){-0.04, 1.0, 2.0}, 3, -0.25, 2.0);
    // all the same: a tenth to both sides; zero: up to one
    check_range((double[]){5.0, 5.0}, 2, 4.5, 5.5);
    check_range((double[]){0.0, 0.0}, 2, 0.0, 1.0);
}

/** One of 1000 far out does not spoil the range; a tail that goes on does count. */
static void outliers_are_left_out(void **state)
{
    (void)state;
    static double value[1000];
    double min, max;
    for (int k = 0; k < 1000; k++) {
        value[k] = k / 1000.0;
    }
    value[7] = 50.0;
    clod_axis_range(value, 1000, &min, &max);
    check_close(min, 0.0, 1e-12);
    check_close(max, 1.0, 1e-12);
}

static void check_axis(double max, const char *units, const char *title, const char *last)
{
    clod_axis axis;
    clod_axis_make(&axis, 0.0, max, "thing", units);
    assert_string_equal(axis.title, title);
    assert_string_equal(axis.text[axis.tick_count - 1], last);
    assert_true(axis.tick_count >= 4 && axis.tick_count <= 11);
    check_close(axis.tick[axis.tick_count - 1], max, 1e-9 * max);
}

static void units_and_numbers_read_well(void **state)
{
    (void)state;
    check_axis(4.0, "m s-1", "thing [m/s]", "4");
    check_axis(2.5, "1", "thing", "2.5");
    check_axis(3.0e-3, "m", "thing [mm]", "3.0");
    check_axis(5.0e-3, "N", "thing [mN]", "5");
    check_axis(8.0e-5, "kg", "thing [mg]", "80");
    check_axis(2.0e-9, "J", "thing [nJ]", "2.0");
    check_axis(5.0e4, "Pa", "thing [kPa]", "50");
    check_axis(40.0, "rad s-1", "thing [rad/s]", "40");
    check_axis(2.0e7, "kg m-3", "thing [10^6 kg/m3]", "20");
}

static void lengths_are_round(void **state)
{
    (void)state;
    char text[32];
    check_close(clod_axis_round_down(0.37), 0.2, 1e-12);
    check_close(clod_axis_round_down(0.5), 0.5, 1e-12);
    check_close(clod_axis_round_down(1.99), 1.0, 1e-12);
    check_close(clod_axis_round_down(99.0), 50.0, 1e-12);
    clod_axis_length_text(0.2, text);
    assert_string_equal(text, "200 mm");
    clod_axis_length_text(5.0, text);
    assert_string_equal(text, "5 m");
    clod_axis_length_text(2e-4, text);
    assert_string_equal(text, "200 \u00b5m");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranges_are_round),
        cmocka_unit_test(outliers_are_left_out),
        cmocka_unit_test(units_and_numbers_read_well),
        cmocka_unit_test(lengths_are_round),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
