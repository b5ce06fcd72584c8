// Random numbers: Random123's published vectors, range, uniformity, independence.

#include <Random123/philox.h>

#include "base/random.h"
#include "support/check.h"

/** From kat_vectors of Random123 (Salmon et al. 2011), philox4x64 with 10 rounds. */
static void philox_gives_the_published_vectors(void **state)
{
    (void)state;
    const uint64_t ones = UINT64_MAX;
    const struct {
        philox4x64_ctr_t counter;
        philox4x64_key_t key;
        uint64_t expected[4];
    } vector[] = {
        {{{0, 0, 0, 0}},
         {{0, 0}},
         {0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}},
        {{{ones, ones, ones, ones}},
         {{ones, ones}},
         {0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}},
        {{{0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89}},
         {{0x452821e638d01377, 0xbe5466cf34e90c6c}},
         {0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}},
    };
    for (int k = 0; k < 3; k++) {
        const philox4x64_ctr_t found = philox4x64(vector[k].counter, vector[k].key);
        assert_memory_equal(found.v, vector[k].expected, sizeof found.v);
    }
}

/** The zero vector through our function: its upper 52 bits, plus half a unit. */
static void the_number_is_the_upper_52_bits(void **state)
{
    (void)state;
    const double found = clod_random_uniform(0, (clod_random_purpose)0, 0, 0);
    check_close(found, (double)(0x16554d9eca36314c >> 12) * 0x1p-52 + 0x1p-53, 0.0);
    check_close(found, 0.08723912359911236, 3e-16); // 0x16554d9eca36314c / 2^64
}

/** seed, purpose, item and draw all count, and none stands for another. */
static void every_argument_counts(void **state)
{
    (void)state;
    for (uint64_t k = 1; k < 100; k++) {
        const double base = clod_random_uniform(k, CLOD_RANDOM_RADIUS, k + 1, k + 2);
        const double other[] = {clod_random_uniform(k + 9, CLOD_RANDOM_RADIUS, k + 1, k + 2),
                                clod_random_uniform(k, CLOD_RANDOM_POSITION, k + 1, k + 2),
                                clod_random_uniform(k, CLOD_RANDOM_RADIUS, k + 2, k + 2),
                                clod_random_uniform(k, CLOD_RANDOM_RADIUS, k + 2, k + 1),
                                clod_random_uniform(k, CLOD_RANDOM_RADIUS, k + 1, k + 3)};
        check_close(clod_random_uniform(k, CLOD_RANDOM_RADIUS, k + 1, k + 2), base, 0.0);
        for (int o = 0; o < 5; o++) {
            assert_true(other[o] != base);
        }
    }
}

static void never_0_and_never_1(void **state)
{
    (void)state;
    for (uint64_t k = 0; k < 1000000; k++) {
        const double x = clod_random_uniform(1, CLOD_RANDOM_TEST, k, 0);
        assert_true(x > 0.0 && x < 1.0);
    }
    // the ends of the range are the smallest and the largest odd multiple of 2^-53
    assert_true(0.0 * 0x1p-52 + 0x1p-53 > 0.0);
    assert_true((double)(UINT64_MAX >> 12) * 0x1p-52 + 0x1p-53 < 1.0);
}

/** Chi squared over 100 bins, 99 degrees of freedom: between its 0.01 % and 99.99 % points. */
static void numbers_are_uniform(void **state)
{
    (void)state;
    for (int by_item = 0; by_item < 2; by_item++) {
        double count[100] = {0.0}, chi2 = 0.0, mean = 0.0;
        for (uint64_t k = 0; k < 1000000; k++) {
            const double x =
                clod_random_uniform(7, CLOD_RANDOM_TEST, by_item ? k : 5, by_item ? 3 : k);
            count[(int)(100.0 * x)] += 1.0;
            mean += 1e-6 * x;
        }
        for (int b = 0; b < 100; b++) {
            chi2 += (count[b] - 1e4) * (count[b] - 1e4) / 1e4;
        }
        check_at_least(chi2, 53.0);
        check_at_most(chi2, 159.0);
        check_close(mean, 0.5, 5.0 * 0.2887e-3); // five standard errors
    }
}

/** Chi squared over 100 bins of equal probability, which the error function tells: bounds as above. */
static void normal_numbers_are_normal(void **state)
{
    (void)state;
    double count[100] = {0.0}, chi2 = 0.0, tie = 0.0;
    double before = 0.0;
    for (uint64_t k = 0; k < 200000; k++) {
        const double x = clod_random_normal(7, CLOD_RANDOM_TEST, 5, 2 * k);
        count[(int)(100.0 * 0.5 * erfc(-x / sqrt(2.0)))] += 1.0;
        tie += before * x / 2e5;
        before = x;
    }
    for (int b = 0; b < 100; b++) {
        chi2 += (count[b] - 2e3) * (count[b] - 2e3) / 2e3;
    }
    check_at_least(chi2, 53.0);
    check_at_most(chi2, 159.0);
    check_close(tie, 0.0, 5.0 / sqrt(2e5)); // five standard errors of a correlation
}

/** Correlation of neighbouring seeds, purposes, items and draws: five standard errors. */
static void streams_are_independent(void **state)
{
    (void)state;
    double sum[4] = {0.0};
    for (uint64_t k = 0; k < 100000; k++) {
        const double x = clod_random_uniform(3, CLOD_RANDOM_RADIUS, k, 0) - 0.5;
        sum[0] += x * (clod_random_uniform(4, CLOD_RANDOM_RADIUS, k, 0) - 0.5);
        sum[1] += x * (clod_random_uniform(3, CLOD_RANDOM_POSITION, k, 0) - 0.5);
        sum[2] += x * (clod_random_uniform(3, CLOD_RANDOM_RADIUS, k + 1, 0) - 0.5);
        sum[3] += x * (clod_random_uniform(3, CLOD_RANDOM_RADIUS, k, 1) - 0.5);
    }
    for (int s = 0; s < 4; s++) {
        check_close(12.0 * sum[s] / 1e5, 0.0, 5.0 / sqrt(1e5));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(philox_gives_the_published_vectors),
        cmocka_unit_test(the_number_is_the_upper_52_bits),
        cmocka_unit_test(every_argument_counts),
        cmocka_unit_test(never_0_and_never_1),
        cmocka_unit_test(numbers_are_uniform),
        cmocka_unit_test(normal_numbers_are_normal),
        cmocka_unit_test(streams_are_independent),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
