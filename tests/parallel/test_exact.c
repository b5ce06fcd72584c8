// Sums that do not depend on order or grouping, and are rounded once: against the processor's
// own rounding of two numbers, against integers, and against what is known to cancel.

#include <float.h>
#include <math.h>
#include <string.h>

#include "parallel/exact.h"
#include "support/check.h"

static uint64_t seed;

/** Next of a series of random bits (xorshift64*). */
static uint64_t random_bits(void)
{
    seed ^= seed >> 12;
    seed ^= seed << 25;
    seed ^= seed >> 27;
    return seed * 2685821657736338717ULL;
}

static double from_bits(uint64_t bits)
{
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static uint64_t bits_of(double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

/** Any finite double, all exponents alike. */
static double random_finite(void)
{
    double number = from_bits(random_bits());
    while (!isfinite(number)) {
        number = from_bits(random_bits());
    }
    return number;
}

/** A number whose exponent is near that of `other`, so that sums are rounded and cancel. */
static double random_near(double other)
{
    int exponent;
    frexp(other, &exponent);
    const double number = frexp(random_finite(), &(int){0});
    return ldexp(number, exponent - 60 + (int)(random_bits() % 120));
}

static double sum_of(const double *number, int count)
{
    clod_exact sum = {0};
    for (int n = 0; n < count; n++) {
        clod_exact_add(&sum, number[n]);
    }
    return clod_exact_value(&sum);
}

static void check_bits(double got, double expected)
{
    if (bits_of(got) != bits_of(expected)) {
        fail_msg("%a in place of %a", got, expected);
    }
}

static void nothing_is_zero(void **state)
{
    (void)state;
    check_bits(sum_of(NULL, 0), 0.0);
    check_bits(sum_of((double[]){-0.0, -0.0}, 2), 0.0);
}

static void one_number_is_itself(void **state)
{
    (void)state;
    seed = 1;
    const double ends[] = {DBL_TRUE_MIN, DBL_MIN, nextafter(DBL_MIN, 0.0), DBL_MAX, 1.0};
    for (int k = 0; k < 5; k++) {
        check_bits(sum_of(&ends[k], 1), ends[k]);
        check_bits(sum_of(&(double){-ends[k]}, 1), -ends[k]);
    }
    for (int k = 0; k < 100000; k++) {
        const double number = random_finite();
        check_bits(sum_of(&number, 1), number == 0.0 ? 0.0 : number);
    }
}

/** IEEE 754: a + b is the exact sum, rounded to nearest, ties to even. */
static void two_numbers_are_rounded_as_the_processor_does(void **state)
{
    (void)state;
    seed = 2;
    for (int k = 0; k < 300000; k++) {
        const double a = random_finite();
        const double b = k % 2 == 0 ? random_near(a) : random_finite();
        if (isfinite(b)) {
            check_bits(sum_of((double[]){a, b}, 2), a + b == 0.0 ? 0.0 : a + b);
        }
    }
    check_bits(sum_of((double[]){DBL_MAX, DBL_MAX}, 2), HUGE_VAL);
    check_bits(sum_of((double[]){-DBL_MAX, -DBL_MAX}, 2), -HUGE_VAL);
    check_bits(sum_of((double[]){DBL_TRUE_MIN, DBL_TRUE_MIN}, 2), 2.0 * DBL_TRUE_MIN);
}

/** A tie is one only when nothing lies below it, however far. */
static void what_lies_far_below_decides_a_tie(void **state)
{
    (void)state;
    const double half = ldexp(1.0, -53);
    check_bits(sum_of((double[]){1.0, half}, 2), 1.0);
    check_bits(sum_of((double[]){1.0, half, DBL_TRUE_MIN}, 3), 1.0 + DBL_EPSILON);
    check_bits(sum_of((double[]){1.0, half, -DBL_TRUE_MIN}, 3), 1.0);
    check_bits(sum_of((double[]){1.0 + DBL_EPSILON, half}, 2), 1.0 + 2.0 * DBL_EPSILON);
    check_bits(sum_of((double[]){1.0 + DBL_EPSILON, half, -DBL_TRUE_MIN}, 3),
               1.0 + DBL_EPSILON);
}

/** A sum beyond the largest double comes back when the rest is added. */
static void a_sum_may_leave_the_range_on_its_way(void **state)
{
    (void)state;
    double number[3000];
    for (int n = 0; n < 1500; n++) {
        number[n] = DBL_MAX;
        number[1500 + n] = -DBL_MAX;
    }
    number[1499] = 1.0;
    number[2999] = DBL_TRUE_MIN;
    check_bits(sum_of(number, 3000), 1.0);
    check_bits(sum_of(number, 1499), HUGE_VAL);
}

__extension__ typedef __int128 wide;

/** Multiples of 2^-200, whose sum integers give. */
static void many_numbers_have_the_sum_of_integers(void **state)
{
    (void)state;
    seed = 3;
    for (int round = 0; round < 200; round++) {
        clod_exact sum = {0};
        wide expected = 0;
        for (int n = 0; n < 7000; n++) {
            const double number = (double)(int64_t)random_bits(); // an integer below 2^63
            expected += (wide)number;
            clod_exact_add(&sum, ldexp(number, -200));
        }
        check_bits(clod_exact_value(&sum), ldexp((double)expected, -200));
    }
}

enum { COUNT = 5000 };

static void shuffle(double *number, int count)
{
    for (int n = count - 1; n > 0; n--) {
        const int other = (int)(random_bits() % (uint64_t)(n + 1));
        const double kept = number[n];
        number[n] = number[other];
        number[other] = kept;
    }
}

/** The sum of groups of any sizes, merged in the order of the groups. */
static double sum_in_groups(const double *number, int count)
{
    clod_exact all = {0};
    for (int n = 0; n < count;) {
        clod_exact group = {0};
        const int end = n + (int)(random_bits() % 1000);
        for (; n < count && n < end; n++) {
            clod_exact_add(&group, number[n]);
        }
        clod_exact_merge(&all, &group);
    }
    return clod_exact_value(&all);
}

static void order_and_groups_do_not_matter(void **state)
{
    (void)state;
    seed = 4;
    static double number[COUNT];
    for (int round = 0; round < 20; round++) {
        for (int n = 0; n < COUNT; n++) { // all magnitudes, or near each other
            number[n] = round % 2 == 0 ? 0x1p-20 * random_finite() : random_near(1.0);
        }
        const double sum = sum_of(number, COUNT);
        for (int again = 0; again < 10; again++) {
            shuffle(number, COUNT);
            check_bits(sum_of(number, COUNT), sum);
            check_bits(sum_in_groups(number, COUNT), sum);
        }
    }
}

static void what_cancels_leaves_nothing(void **state)
{
    (void)state;
    seed = 5;
    static double number[2 * COUNT + 1];
    for (int round = 0; round < 20; round++) {
        for (int n = 0; n < COUNT; n++) {
            number[n] = random_finite();
            number[COUNT + n] = -number[n];
        }
        number[2 * COUNT] = random_near(DBL_MIN);
        const double left = number[2 * COUNT];
        shuffle(number, 2 * COUNT + 1);
        check_bits(sum_of(number, 2 * COUNT + 1), left);
        check_bits(sum_in_groups(number, 2 * COUNT + 1), left);
    }
}

static void infinities_and_nan_stay(void **state)
{
    (void)state;
    check_bits(sum_of((double[]){1.0, HUGE_VAL, 2.0}, 3), HUGE_VAL);
    check_bits(sum_of((double[]){-HUGE_VAL, 5.0, -HUGE_VAL}, 3), -HUGE_VAL);
    assert_true(isnan(sum_of((double[]){HUGE_VAL, -HUGE_VAL}, 2)));
    assert_true(isnan(sum_of((double[]){1.0, (double)NAN, HUGE_VAL}, 3)));
    clod_exact all = {0};
    clod_exact part = {0};
    clod_exact_add(&part, -HUGE_VAL);
    clod_exact_merge(&all, &part);
    check_bits(clod_exact_value(&all), -HUGE_VAL);
    clod_exact_add(&all, HUGE_VAL);
    assert_true(isnan(clod_exact_value(&all)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_zero),
        cmocka_unit_test(one_number_is_itself),
        cmocka_unit_test(two_numbers_are_rounded_as_the_processor_does),
        cmocka_unit_test(what_lies_far_below_decides_a_tie),
        cmocka_unit_test(a_sum_may_leave_the_range_on_its_way),
        cmocka_unit_test(many_numbers_have_the_sum_of_integers),
        cmocka_unit_test(order_and_groups_do_not_matter),
        cmocka_unit_test(what_cancels_leaves_nothing),
        cmocka_unit_test(infinities_and_nan_stay),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
