// Means of ten blocks, worked out by hand: which are those of a steady stream, and what is said of the
// others. About their middle the numbers 0 to 9 have a sum of squares of 82.5.

#include "sim/steady_doubt.h"

#include <math.h>
#include <string.h>

#include "support/check.h"

#define BLOCKS CLOD_STEADY_BLOCKS

/** middle + slope (k - 4.5) + scatter (-1)^k */
static void make(double *block, double middle, double slope, double scatter)
{
    for (int k = 0; k < BLOCKS; k++) {
        block[k] = middle + slope * (k - 4.5) + (k % 2 == 0 ? scatter : -scatter);
    }
}

/** A scatter of +1, -1, ... has a slope of -5/82.5 = -2/33 itself, and a sum of squares about its line
 *  of 10 - 25/82.5; so the standard error of a slope is sqrt((10 - 25/82.5)/8/82.5) = 4/33, and
 *  the slope is three of them where 14/33 = 0.4242 is added. */
static void a_trend_is_told_from_three_standard_errors_on(void **unused)
{
    (void)unused;
    double block[BLOCKS];
    make(block, 10.0, 0.43, 1.0);
    check_close(clod_steady_doubt_of(block, BLOCKS).change, 10.0 * (0.43 - 2.0 / 33.0), 1e-12);
    make(block, 10.0, -0.43, -1.0);
    check_close(clod_steady_doubt_of(block, BLOCKS).change, -10.0 * (0.43 - 2.0 / 33.0), 1e-12);
    make(block, 10.0, 0.42, 1.0);
    assert_true(clod_steady_doubt_of(block, BLOCKS).change == 0.0);
}

/** Without scatter every trend is one for sure: ten blocks at a slope of 1 % of the mean rise by 10 %. */
static void a_trend_of_less_than_a_tenth_is_none(void **unused)
{
    (void)unused;
    double block[BLOCKS];
    make(block, 1.0, 0.0101, 0.0);
    check_close(clod_steady_doubt_of(block, BLOCKS).change, 0.101, 1e-9);
    make(block, -1.0, 0.0101, 0.0);
    check_close(clod_steady_doubt_of(block, BLOCKS).change, 0.101, 1e-9);
    make(block, 1.0, 0.0099, 0.0);
    assert_true(clod_steady_doubt_of(block, BLOCKS).change == 0.0);
}

/** One empty block of ten has a trend of 4.5/82.5, and errors of sqrt((0.9 - 4.5^2/82.5)/8/82.5): a
 *  ratio of 1.73. */
static void first_blocks_without_a_stream_are_told(void **unused)
{
    (void)unused;
    double block[BLOCKS] = {0, 1, 1, 1, 1, 1, 1, 1, 1, 1};
    clod_steady_doubt doubt = clod_steady_doubt_of(block, BLOCKS);
    assert_int_equal(doubt.late, 1);
    assert_true(doubt.change == 0.0);
    block[1] = block[2] = 0.0;
    assert_int_equal(clod_steady_doubt_of(block, BLOCKS).late, 3);
    block[1] = 1.0; // now and then nothing comes
    assert_int_equal(clod_steady_doubt_of(block, BLOCKS).late, 0);
    memset(block, 0, sizeof block); // nothing ever does
    doubt = clod_steady_doubt_of(block, BLOCKS);
    assert_true(doubt.late == 0 && doubt.change == 0.0);
    make(block, 1.0, 0.0, 0.0);
    block[9] = 0.0;
    doubt = clod_steady_doubt_of(block, BLOCKS);
    assert_true(doubt.late == 0 && doubt.change == 0.0);
}

static void four_blocks_are_too_few(void **unused)
{
    (void)unused;
    double block[BLOCKS] = {0, 1, 2, 3, 4};
    assert_int_equal(clod_steady_doubt_of(block, 5).late, 1);
    check_close(clod_steady_doubt_of(block, 5).change, 5.0, 1e-12);
    block[1] = (double)NAN; // the line is the same
    assert_int_equal(clod_steady_doubt_of(block, 5).late, 0);
    assert_true(clod_steady_doubt_of(block, 5).change == 0.0);
    block[5] = 5.0;
    check_close(clod_steady_doubt_of(block, 6).change, 6.0, 1e-12);
    assert_true(clod_steady_doubt_of(block, 0).change == 0.0);
    assert_false(clod_steady_doubt_not_zero(block, 0, 0.0));
    make(block, 1.0, 0.0, 0.0);
    assert_false(clod_steady_doubt_not_zero(block, 4, 0.0));
    assert_true(clod_steady_doubt_not_zero(block, 5, 0.0));
}

/** Ten values m + 1, m - 1, ... have a standard deviation of sqrt(10/9), so their mean m has an
 *  error of 1/3. */
static void a_mean_is_not_zero_beyond_three_errors_and_a_tenth(void **unused)
{
    (void)unused;
    double block[BLOCKS];
    make(block, 1.01, 0.0, 1.0);
    assert_true(clod_steady_doubt_not_zero(block, BLOCKS, 10.0));
    assert_false(clod_steady_doubt_not_zero(block, BLOCKS, 10.2));
    make(block, -1.01, 0.0, 1.0);
    assert_true(clod_steady_doubt_not_zero(block, BLOCKS, 10.0));
    make(block, 0.99, 0.0, 1.0);
    assert_false(clod_steady_doubt_not_zero(block, BLOCKS, 0.0));
}

static void check_told(const double *block, const char *wanted)
{
    const clod_steady_time steady = {.since = 2.0, .block = 0.1};
    json_t *list = json_array();
    assert_true(clod_steady_doubt_warn(list, "Gauge lip: the mass flow", "kg/s", block, BLOCKS,
                                       &steady));
    assert_int_equal(json_array_size(list), 1);
    const char *told = json_string_value(json_array_get(list, 0));
    assert_true(strncmp(told, wanted, strlen(wanted)) == 0);
    assert_non_null(strstr(told, "output.steady_since"));
    json_decref(list);
}

static void warnings_say_what_is_wrong_and_when(void **unused)
{
    (void)unused;
    double block[BLOCKS] = {0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
    check_told(block,
               "Gauge lip: the mass flow is 0 until 2.2 s, and its mean is taken from 2 s on");
    make(block, 1.0, 0.06, 0.0);
    check_told(block, "Gauge lip: the mass flow rises by 0.6 kg/s from 2 to 3 s");
    make(block, 1.0, -0.06, 0.0);
    check_told(block, "Gauge lip: the mass flow falls by 0.6 kg/s from 2 to 3 s");
    make(block, 1.0, 0.0, 0.1);
    json_t *list = json_array();
    const clod_steady_time steady = {.since = 2.0, .block = 0.1};
    assert_false(clod_steady_doubt_warn(list, "Gauge lip: the mass flow", "kg/s", block, BLOCKS,
                                        &steady));
    assert_int_equal(json_array_size(list), 0);
    json_decref(list);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_trend_is_told_from_three_standard_errors_on),
        cmocka_unit_test(a_trend_of_less_than_a_tenth_is_none),
        cmocka_unit_test(first_blocks_without_a_stream_are_told),
        cmocka_unit_test(four_blocks_are_too_few),
        cmocka_unit_test(a_mean_is_not_zero_beyond_three_errors_and_a_tenth),
        cmocka_unit_test(warnings_say_what_is_wrong_and_when),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
