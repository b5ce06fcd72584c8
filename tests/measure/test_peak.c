// Peak of synthetic shear curves: with and without a peak, with and without noise.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "base/random.h"
#include "measure/peak.h"

#define PI 3.14159265358979323846
#define STEP 1e-5   // m between samples
#define WINDOW 1e-3 // m
#define BEYOND 2e-3 // m
#define LIMIT 15e-3 // m, where the caller stops

static double normal(uint64_t seed, uint64_t item)
{
    const double u = clod_random_uniform(seed, CLOD_RANDOM_TEST, item, 0);
    const double v = clod_random_uniform(seed, CLOD_RANDOM_TEST, item, 1);
    return sqrt(-2.0 * log(u)) * cos(2.0 * PI * v);
}

typedef double curve(double x);

/** Shear along a curve with noise until passed or LIMIT; returns where it ended. */
static double shear(curve *tau, double noise, uint64_t seed, double step, clod_peak *self)
{
    clod_peak_init(self, WINDOW, BEYOND);
    for (int k = 0; k * step <= LIMIT; k++) {
        const double x = k * step;
        if (clod_peak_add(self, x, tau(x) + noise * normal(seed, (uint64_t)k), 2.0 * x)) {
            return x;
        }
    }
    return LIMIT;
}

/** Parabola with its top, 1000 Pa, at 5 mm; curvature 2 * 2e7 Pa/m2. */
static double parabola(double x)
{
    return 1000.0 - 2e7 * (x - 5e-3) * (x - 5e-3);
}

// A moving average over w lowers a parabola y = -a x^2 by a w^2/12: 2e7 * 1e-6/12 = 1.667 Pa
// (= w^2/24 times the curvature 2 a).
static void parabola_is_found(void **state)
{
    (void)state;
    clod_peak self;
    const double end = shear(parabola, 0.0, 0, STEP, &self);
    const clod_peak_result found = clod_peak_summary(&self);
    assert_true(found.passed);
    assert_true(fabs(found.tau - (1000.0 - 2e7 * 1e-6 / 12.0)) < 0.05);
    assert_true(fabs(found.displacement - 5e-3) < WINDOW / CLOD_PEAK_BINS);
    // sigma = 2 x was given: its mean over the window of the peak, not over the whole curve
    assert_true(fabs(found.sigma - 2.0 * found.displacement) < 1e-12);
    // seen as passed half a window after the smoothed curve is BEYOND further, plus a bin
    assert_true(end >= 5e-3 + BEYOND + WINDOW / 2.0 - 2.0 * WINDOW / CLOD_PEAK_BINS);
    assert_true(end <= 5e-3 + BEYOND + WINDOW / 2.0 + 2.0 * WINDOW / CLOD_PEAK_BINS);
}

/** Rise to a peak of 1200 Pa at 3 mm and fall to a residual of 800 Pa. */
static double overconsolidated(double x)
{
    const double rise = x < 3e-3 ? sin(0.5 * PI * x / 3e-3) : 1.0;
    const double fall = x < 3e-3 ? 0.0 : 1.0 - exp(-pow((x - 3e-3) / 3e-3, 2.0));
    return 1200.0 * rise - 400.0 * fall;
}

/** Rise that never ends within the limit. */
static double plateau(double x)
{
    return 1000.0 * (1.0 - exp(-x / 3e-3));
}

static double constant(double x)
{
    (void)x;
    return 500.0;
}

static void rise_to_a_plateau_ends_at_the_limit(void **state)
{
    (void)state;
    clod_peak self;
    assert_true(shear(plateau, 0.0, 0, STEP, &self) == LIMIT);
    const clod_peak_result found = clod_peak_summary(&self);
    assert_false(found.passed);
    // mean of the curve over the last window, the largest: between the curve at its two ends
    assert_true(found.tau > plateau(LIMIT - WINDOW - WINDOW / CLOD_PEAK_BINS));
    assert_true(found.tau < plateau(LIMIT));
    assert_true(found.displacement > LIMIT - 0.6 * WINDOW);
}

static void constant_curve_passes_beyond_its_first_window(void **state)
{
    (void)state;
    clod_peak self;
    const double end = shear(constant, 0.0, 0, STEP, &self);
    assert_true(end < WINDOW + BEYOND + 2.0 * WINDOW / CLOD_PEAK_BINS);
    assert_true(clod_peak_summary(&self).tau == 500.0);
    assert_true(clod_peak_summary(&self).tau_error == 0.0);
}

// Noise of 5 % per sample, 100 samples per window: 0.5 % in the mean, 6 Pa. The largest of a
// noisy curve is too large by about that; it must be within three of them.
static void noisy_peak_is_found(void **state)
{
    (void)state;
    enum { TRIALS = 300 };
    double sum = 0.0;
    double squares = 0.0;
    double reported = 0.0;
    for (uint64_t seed = 0; seed < TRIALS; seed++) {
        clod_peak self;
        shear(overconsolidated, 60.0, seed, STEP, &self);
        const clod_peak_result found = clod_peak_summary(&self);
        assert_true(found.passed);
        assert_true(fabs(found.displacement - 3e-3) < 1.2e-3);
        assert_true(fabs(found.tau - 1200.0) < 35.0);
        sum += (found.tau - 1200.0) / TRIALS;
        squares += pow(found.tau - 1200.0, 2.0) / TRIALS;
        reported += found.tau_error * found.tau_error / TRIALS;
    }
    assert_true(fabs(sum) < 9.0);
    const double spread = sqrt(squares - sum * sum); // of the largest value: below 6 Pa
    assert_true(spread < 6.5);
    assert_true(sqrt(reported) > 6.0 && sqrt(reported) < 9.5); // blocking takes the largest
}

/** Constant with noise that holds for 25 samples, a quarter of the window. */
static double held_noise(uint64_t seed, int k)
{
    return 500.0 + 20.0 * normal(seed, (uint64_t)k / 25);
}

// The mean of 4 independent values of 20 Pa: 10 Pa. Bins alone (16 of them, in runs of four)
// would say half of that.
static void blocking_sees_correlation(void **state)
{
    (void)state;
    enum { TRIALS = 1000 };
    double reported = 0.0;
    for (uint64_t seed = 0; seed < TRIALS; seed++) {
        clod_peak self;
        clod_peak_init(&self, WINDOW, BEYOND);
        for (int k = 0; k <= 101; k++) { // one window, closed by the sample after it
            clod_peak_add(&self, k * STEP, held_noise(seed, k), 0.0);
        }
        const double error = clod_peak_summary(&self).tau_error;
        assert_true(error > 0.0);
        reported += error * error / TRIALS;
    }
    assert_true(sqrt(reported) > 8.5 && sqrt(reported) < 12.0);
}

static double slope(double x)
{
    return 1e5 * x;
}

/** A straight rise has no noise, however steep. */
static void a_trend_is_no_noise(void **state)
{
    (void)state;
    clod_peak self;
    shear(slope, 0.0, 0, STEP, &self);
    const clod_peak_result found = clod_peak_summary(&self);
    // the curve rises by 100 Pa over the window; bins take one sample more or less: 0.5 Pa
    assert_true(found.tau > 1400.0 && found.tau_error < 0.25);
}

/** Samples further apart than a bin: bins grow with them. */
static void coarse_samples_work(void **state)
{
    (void)state;
    clod_peak self;
    const double step = 1.5 * WINDOW / CLOD_PEAK_BINS;
    shear(parabola, 0.0, 0, step, &self);
    const clod_peak_result found = clod_peak_summary(&self);
    assert_true(found.passed);
    // 16 samples at 1.5 bins: a window of 1.5 mm, 2e7 * 2.25e-6/12 = 3.75 Pa lower
    assert_true(fabs(found.tau - (1000.0 - 3.75)) < 0.3);
    assert_true(fabs(found.displacement - 5e-3) < step);
}

static void before_a_window_is_full(void **state)
{
    (void)state;
    clod_peak self;
    clod_peak_init(&self, WINDOW, BEYOND);
    assert_true(isnan(clod_peak_summary(&self).tau));
    assert_false(clod_peak_add(&self, 0.0, 10.0, 1.0));
    assert_true(clod_peak_summary(&self).tau == 10.0);
    for (int k = 1; k < 40; k++) {
        assert_false(clod_peak_add(&self, k * STEP, 10.0, 1.0));
    }
    const clod_peak_result found = clod_peak_summary(&self);
    assert_true(found.tau == 10.0 && isnan(found.tau_error) && !found.passed);
}

static void bytes_are_enough(void **state)
{
    (void)state;
    clod_peak one;
    clod_peak two;
    clod_peak_init(&one, WINDOW, BEYOND);
    clod_peak_init(&two, WINDOW, BEYOND);
    for (int k = 0; k < 700; k++) {
        const double x = k * STEP;
        assert_true(clod_peak_add(&one, x, parabola(x), 1.0) ==
                    clod_peak_add(&two, x, parabola(x), 1.0));
        unsigned char bytes[sizeof two];
        memcpy(bytes, &two, sizeof two);
        memset(&two, 0xff, sizeof two);
        memcpy(&two, bytes, sizeof two);
    }
    assert_memory_equal(&one, &two, sizeof one);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parabola_is_found),
        cmocka_unit_test(rise_to_a_plateau_ends_at_the_limit),
        cmocka_unit_test(constant_curve_passes_beyond_its_first_window),
        cmocka_unit_test(noisy_peak_is_found),
        cmocka_unit_test(blocking_sees_correlation),
        cmocka_unit_test(a_trend_is_no_noise),
        cmocka_unit_test(coarse_samples_work),
        cmocka_unit_test(before_a_window_is_full),
        cmocka_unit_test(bytes_are_enough),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
