// Steady state on synthetic signals: constant, noise, ramp, approach, oscillation.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "base/random.h"
#include "measure/steady.h"

#define PI 3.14159265358979323846
#define SAMPLES 50 // per block

static double normal(uint64_t seed, uint64_t item)
{
    const double u = clod_random_uniform(seed, CLOD_RANDOM_TEST, item, 0);
    const double v = clod_random_uniform(seed, CLOD_RANDOM_TEST, item, 1);
    return sqrt(-2.0 * log(u)) * cos(2.0 * PI * v);
}

/** A signal at sample k of a run with this seed. */
typedef double signal(uint64_t seed, int k);

/** Blocks until steady, or `most` + 1; the detector is left in that state. */
static int blocks_to_steady(clod_steady *self, signal *tau, signal *height, uint64_t seed,
                            int most)
{
    for (int k = 0; k < most * SAMPLES; k++) {
        if (clod_steady_add(self, tau(seed, k), height(seed, k), (double)k)) {
            assert_int_equal((k + 1) % SAMPLES, 0); // decided at the end of a block only
            return (k + 1) / SAMPLES;
        }
    }
    return most + 1;
}

static int run(signal *tau, signal *height, int64_t blocks, double tolerance, int most,
               clod_steady *self)
{
    clod_steady_init(self, blocks, SAMPLES, tolerance, 0.2 * tolerance);
    return blocks_to_steady(self, tau, height, 1, most);
}

static double constant(uint64_t seed, int k)
{
    (void)seed;
    (void)k;
    return 0.04;
}

/** Relative noise of 20 % per sample: 20 %/sqrt(50) = 2.83 % per block. */
static double noisy(uint64_t seed, int k)
{
    return 1e4 * (1.0 + 0.2 * normal(seed, (uint64_t)k));
}

static void constant_signal_is_steady_at_once(void **state)
{
    (void)state;
    clod_steady self;
    assert_int_equal(run(constant, constant, 5, 0.02, 20, &self), 5);
    const clod_steady_result found = clod_steady_summary(&self);
    assert_true(found.steady);
    assert_int_equal(found.blocks, 5);
    assert_true(fabs(found.tau.value - 0.04) < 1e-15);
    assert_true(found.tau.error < 1e-15 && fabs(found.tau.trend) < 1e-15);
    assert_true(fabs(found.height.value - 0.04) < 1e-15);
}

static double ramp(uint64_t seed, int k)
{
    (void)seed;
    return 1e4 * (1.0 + 0.02 * k / SAMPLES); // 2 % per block
}

// Over 5 blocks a line that rises 0.2 % per block changes by 0.8 %; that is sure, so it must be
// below half of 2 %. 0.3 % per block, 1.2 %, is not.
static double slow_ramp(uint64_t seed, int k)
{
    (void)seed;
    return 1e4 * (1.0 + 0.002 * k / SAMPLES);
}

static double faster_ramp(uint64_t seed, int k)
{
    (void)seed;
    return 1e4 * exp(0.003 * k / SAMPLES); // stays 0.3 % per block of what it has become
}

static double falling_ramp(uint64_t seed, int k)
{
    (void)seed;
    return 1e4 * exp(-0.003 * k / SAMPLES);
}

static void ramps(void **state)
{
    (void)state;
    clod_steady self;
    assert_int_equal(run(ramp, constant, 5, 0.02, 40, &self), 41);
    assert_int_equal(run(constant, ramp, 5, 0.02, 40, &self), 41); // a growing height counts
    assert_int_equal(run(slow_ramp, constant, 5, 0.02, 40, &self), 5);
    assert_int_equal(run(faster_ramp, constant, 5, 0.02, 64, &self), 65);
    assert_int_equal(run(falling_ramp, constant, 5, 0.02, 64, &self), 65);
    const clod_steady_result found = clod_steady_summary(&self);
    assert_false(found.steady);
    assert_int_equal(found.blocks, 5);
}

/** Dilation of 0.2 % of the height per block: 0.8 % over 5 blocks, twice what height may do. */
static double dilating(uint64_t seed, int k)
{
    (void)seed;
    return 0.04 * exp(0.002 * k / SAMPLES);
}

static void slow_dilation_is_not_steady(void **state)
{
    (void)state;
    clod_steady self;
    assert_int_equal(run(constant, dilating, 5, 0.02, 64, &self), 65);
    clod_steady_init(&self, 5, SAMPLES, 0.02, (double)INFINITY); // the height does not decide
    assert_int_equal(blocks_to_steady(&self, constant, dilating, 1, 64), 5);
}

static double approach(uint64_t seed, int k)
{
    (void)seed;
    return 1e4 * (1.0 - exp(-(double)k / (4.0 * SAMPLES))); // decays over 4 blocks
}

static double noisy_approach(uint64_t seed, int k)
{
    return 1e4 * (1.0 - exp(-(double)k / (2.0 * SAMPLES))) * noisy(seed, k) / 1e4; // 2 blocks
}

// After b blocks the mean of block j is 1 - A exp(-j/4), A = 4 (1 - exp(-1/4)). The change over
// the last five, by a fitted line, falls below 1 % when its start is about 1.6 % away: by hand
// with a table of these averages, at the 21st block.
static void exponential_approach_is_waited_for(void **state)
{
    (void)state;
    clod_steady self;
    const int blocks = run(approach, constant, 5, 0.02, 64, &self);
    double mean[64];
    int expected = 0;
    for (int b = 5; b <= 64 && expected == 0; b++) { // the condition, worked out on its own
        double y = 0.0;
        double moment = 0.0;
        for (int j = 0; j < 5; j++) {
            mean[j] = 1.0 - 4.0 * (1.0 - exp(-0.25)) * exp(-0.25 * (b - 5 + j));
            y += mean[j] / 5.0;
            moment += (j - 2.0) * mean[j];
        }
        expected = moment / 10.0 * 4.0 <= 0.01 * y ? b : 0;
    }
    assert_in_range(blocks, expected - 1, expected + 1); // samples sum a little differently
    const clod_steady_result found = clod_steady_summary(&self);
    assert_true(found.steady && found.tau.value > 0.985e4 && found.tau.value < 1e4);
}

/** With noise of 2.8 % per block the mean is within two tolerances nearly always. */
static void noisy_approach_ends_near_the_plateau(void **state)
{
    (void)state;
    int near = 0;
    int done = 0;
    for (uint64_t seed = 0; seed < 200; seed++) {
        clod_steady self;
        clod_steady_init(&self, 5, SAMPLES, 0.02, 0.2 * 0.02);
        const int blocks = blocks_to_steady(&self, noisy_approach, constant, seed, 64);
        const clod_steady_result found = clod_steady_summary(&self);
        done += blocks <= 64 ? 1 : 0;
        near += fabs(found.tau.value - 1e4) <= 0.04e4 ? 1 : 0;
    }
    assert_true(done >= 198);
    assert_true(near >= 190);
}

/** Period of three and a half blocks, 10 %: no block average is like the other, no trend. */
static double oscillation(uint64_t seed, int k)
{
    (void)seed;
    return 1e4 * (1.0 + 0.1 * sin(2.0 * PI * k / (3.5 * SAMPLES)));
}

/** Twice per block: gone in the averages. */
static double fast_oscillation(uint64_t seed, int k)
{
    (void)seed;
    return 1e4 * (1.0 + 0.1 * sin(4.0 * PI * k / SAMPLES));
}

static void oscillations(void **state)
{
    (void)state;
    clod_steady self;
    assert_int_equal(run(fast_oscillation, constant, 5, 0.02, 10, &self), 5);
    const int blocks = run(oscillation, constant, 5, 0.02, 64, &self);
    assert_true(blocks > 5 && blocks <= 64); // needs a longer window to be sure of no trend
    const clod_steady_result found = clod_steady_summary(&self);
    assert_true(fabs(found.tau.value - 1e4) < 0.02e4);
}

// 40 % noise per block: the trend over 64 blocks is known to 40 % sqrt(12/64) = 17 %.
static double wild(uint64_t seed, int k)
{
    return 1e4 * (1.0 + 0.4 * sqrt((double)SAMPLES) * normal(seed, (uint64_t)k));
}

static void too_noisy_is_never_steady(void **state)
{
    (void)state;
    clod_steady self;
    assert_int_equal(run(wild, constant, 5, 0.02, 200, &self), 201);
}

// White noise: the standard error of a window's mean is its scatter/sqrt(number of blocks),
// true between repeats. A fixed number of blocks (never steady: tolerance 1e-9).
static double spread_of_means(signal *tau, double *reported)
{
    enum { TRIALS = 2000 };
    double sum = 0.0;
    double squares = 0.0;
    *reported = 0.0;
    for (uint64_t trial = 0; trial < TRIALS; trial++) {
        clod_steady self;
        clod_steady_init(&self, 8, SAMPLES, 1e-9, 0.2 * 1e-9);
        assert_int_equal(blocks_to_steady(&self, tau, constant, trial, 8), 9);
        const clod_steady_mean mean = clod_steady_summary(&self).tau;
        sum += mean.value / TRIALS;
        squares += (mean.value - 1e4) * (mean.value - 1e4) / TRIALS;
        *reported += mean.error * mean.error / TRIALS;
    }
    *reported = sqrt(*reported);
    return sqrt(squares - (sum - 1e4) * (sum - 1e4));
}

/** Mean of ten neighbours of white noise: correlated over a fifth of a block. */
static double correlated(uint64_t seed, int k)
{
    double sum = 0.0;
    for (int j = 0; j < 10; j++) {
        sum += normal(seed, (uint64_t)(k + j));
    }
    return 1e4 * (1.0 + 0.02 * sum);
}

static void standard_error_is_that_between_repeats(void **state)
{
    (void)state;
    double reported;
    double found = spread_of_means(noisy, &reported);
    // by hand: 1e4 * 0.2/sqrt(50 * 8) = 100
    assert_true(fabs(found / 100.0 - 1.0) < 0.06);
    assert_true(fabs(reported / found - 1.0) < 0.06);
    found = spread_of_means(correlated, &reported);
    assert_true(fabs(reported / found - 1.0) < 0.15); // blocks take care of the correlation
}

// Blocks of one sample, 10, 12, 17. By hand: mean 13, slope 7/2 per block, residuals 0.5, -1,
// 0.5, so s^2 = 1.5/(3 - 2). The line ends one and a half blocks behind the middle: 13 + 1.5
// * 3.5 = 18.25. Errors: of the slope sqrt(1.5/2), of the change over two blocks twice that, of
// the end sqrt(1.5 (1/3 + 1.5^2/2)).
static void the_line_is_known_to_its_end(void **state)
{
    (void)state;
    static const double VALUE[] = {10.0, 12.0, 17.0};
    clod_steady self;
    clod_steady_init(&self, 3, 1, 1e-9, 1e-9);
    for (int k = 0; k < 3; k++) {
        clod_steady_add(&self, VALUE[k], 1.0, (double)k);
    }
    const clod_steady_mean found = clod_steady_summary(&self).tau;
    assert_true(fabs(found.value - 13.0) < 1e-12);
    assert_true(fabs(found.trend - 7.0) < 1e-12);
    assert_true(fabs(found.trend_error - 2.0 * sqrt(0.75)) < 1e-12);
    assert_true(fabs(found.end - 18.25) < 1e-12);
    assert_true(fabs(found.end_error - sqrt(1.5 * (1.0 / 3.0 + 1.125))) < 1e-12);
}

static void nothing_yet(void **state)
{
    (void)state;
    clod_steady self;
    clod_steady_init(&self, 5, 2, 0.02, 0.2 * 0.02);
    clod_steady_result found = clod_steady_summary(&self);
    assert_false(found.steady);
    assert_int_equal(found.blocks, 0);
    assert_true(isnan(found.tau.value) && isnan(found.tau.error));
    for (int k = 0; k < 4; k++) {
        assert_false(clod_steady_add(&self, k, 1.0, 1.0));
    }
    found = clod_steady_summary(&self);
    assert_int_equal(found.blocks, 2);
    assert_true(found.tau.value == 1.5 && isnan(found.tau.error)); // (0 + 1 + 2 + 3)/4
}

/** Only the last 64 blocks count, and the bytes of the detector are all of it. */
static void old_blocks_are_forgotten_and_bytes_are_enough(void **state)
{
    (void)state;
    clod_steady self;
    clod_steady_init(&self, CLOD_STEADY_MAX, SAMPLES, 0.02, 0.2 * 0.02);
    for (int k = 0; k < 30 * SAMPLES; k++) {
        assert_false(clod_steady_add(&self, 1e6, 0.04, 1.0));
    }
    unsigned char bytes[sizeof self];
    for (int k = 0; k < 64 * SAMPLES - 1; k++) {
        assert_false(clod_steady_add(&self, noisy(1, k), 0.04, 1.0));
        memcpy(bytes, &self, sizeof self);
        memset(&self, 0xff, sizeof self);
        memcpy(&self, bytes, sizeof self);
    }
    assert_true(clod_steady_add(&self, noisy(1, 64 * SAMPLES - 1), 0.04, 1.0));
    assert_int_equal(clod_steady_summary(&self).blocks, 64);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constant_signal_is_steady_at_once),
        cmocka_unit_test(ramps),
        cmocka_unit_test(slow_dilation_is_not_steady),
        cmocka_unit_test(exponential_approach_is_waited_for),
        cmocka_unit_test(noisy_approach_ends_near_the_plateau),
        cmocka_unit_test(oscillations),
        cmocka_unit_test(too_noisy_is_never_steady),
        cmocka_unit_test(standard_error_is_that_between_repeats),
        cmocka_unit_test(the_line_is_known_to_its_end),
        cmocka_unit_test(nothing_yet),
        cmocka_unit_test(old_blocks_are_forgotten_and_bytes_are_enough),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
