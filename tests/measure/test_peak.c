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

/** Shear along a curve with noise until passed or LIMIT; returns where it ended. A sample
 * stands for the way since the one before: the curve in the middle of it. */
static double shear(curve *tau, double noise, uint64_t seed, double step, clod_peak *self)
{
    clod_peak_init(self, WINDOW, BEYOND);
    for (int k = 0; k * step <= LIMIT; k++) {
        const double x = k * step;
        const double mid = x - 0.5 * step;
        if (clod_peak_add(self, x, tau(mid) + noise * normal(seed, (uint64_t)k), 2.0 * mid)) {
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

/** Samples further apart than a bin: the window stays what it is. */
static void coarse_samples_work(void **state)
{
    (void)state;
    clod_peak self;
    const double step = 1.5 * WINDOW / CLOD_PEAK_BINS;
    shear(parabola, 0.0, 0, step, &self);
    const clod_peak_result found = clod_peak_summary(&self);
    assert_true(found.passed);
    // a parabola in its middle is higher than its mean over 93.75 um by 2e7 * (93.75 um)^2/12 =
    // 0.015 Pa, and a sample that ends in a window counts with its mean: less than 0.1 Pa
    assert_true(fabs(found.tau - (1000.0 - 2e7 * 1e-6 / 12.0)) < 0.1);
    assert_true(fabs(found.displacement - 5e-3) < step);
}

/** The mean of a curve of straight lines, from its integral, between two displacements. */
typedef double integral(double x);

static clod_peak_result peak_of_means(integral *area, double step, double jitter, double window)
{
    clod_peak self;
    clod_peak_init(&self, window, BEYOND);
    double before = 0.0;
    clod_peak_add(&self, before, 0.0, 0.0);
    for (int k = 1; before < LIMIT; k++) {
        // spacing from (1 - jitter) to (1 + jitter) steps
        const double random = clod_random_uniform(3, CLOD_RANDOM_TEST, (uint64_t)k, 0);
        const double x = before + step * (1.0 + jitter * (2.0 * random - 1.0));
        const double tau = (area(x) - area(before)) / (x - before);
        if (clod_peak_add(&self, x, tau, 1.0)) {
            break;
        }
        before = x;
    }
    return clod_peak_summary(&self);
}

/** Triangle: up by 200 kPa/m to 1000 Pa at 5 mm, down by a third of that behind it. */
static double triangle_area(double x)
{
    const double top = 5e-3;
    return x < top ? 0.5 * 2e5 * x * x
                   : 0.5 * 2e5 * top * top + 1000.0 * (x - top) -
                         0.5 * (2e5 / 3.0) * (x - top) * (x - top);
}

// Slopes a = 2e5 and b = a/3: the window with the largest mean has equal ends, a u = b (w - u),
// so u = w/4, and the mean is lower than the top by w a b/(2 (a + b)) = w a/8 = 25 Pa per mm.
// It is looked for in steps of w/16, so at most (w/32)^2 (a + b)/(2 w) = w a/1536 is missed.
static void a_triangle_is_lowered_by_the_window(void **state)
{
    (void)state;
    static const struct {
        double step, jitter, window;
    } WAYS[] = {{1e-5, 0.0, 1e-3}, {1e-5, 0.9, 1e-3},   {4e-5, 0.9, 1e-3}, {1e-6, 0.0, 1e-3},
                {1e-5, 0.9, 2e-3}, {1e-5, 0.0, 0.5e-3}, {9e-5, 0.9, 1e-3}, {1.5e-4, 0.0, 1e-3}};
    for (size_t k = 0; k < sizeof WAYS / sizeof *WAYS; k++) {
        const double w = WAYS[k].window;
        const double fine = 1.01 * w * 2e5 / 1536.0;
        // a sample that is longer than a bin has the mean of its way in all of it
        const double coarse = WAYS[k].step > w / CLOD_PEAK_BINS ? WAYS[k].step * 2e5 / 16.0 : 0;
        const clod_peak_result found =
            peak_of_means(triangle_area, WAYS[k].step, WAYS[k].jitter, w);
        assert_true(found.passed);
        assert_true(fabs(found.tau - (1000.0 - w * 2e5 / 8.0)) < fine + coarse);
        // its middle: the top, less w/4, plus w/2
        assert_true(fabs(found.displacement - (5e-3 + 0.25 * w)) <
                    w / CLOD_PEAK_BINS + WAYS[k].step);
    }
}

/** 500 Pa, but 900 Pa for 0.25 mm: what slip and stick may do. */
static double spike_area(double x)
{
    return 500.0 * x + 400.0 * fmin(fmax(x - 1.5e-3, 0.0), 0.25e-3);
}

// A quarter of the window of 1 mm: 600 Pa; all of one of 0.25 mm: 900 Pa less a bin's part.
static void a_spike_counts_by_its_way(void **state)
{
    (void)state;
    assert_true(fabs(peak_of_means(spike_area, 1e-5, 0.9, 1e-3).tau - 600.0) < 1e-9);
    const double narrow = peak_of_means(spike_area, 1e-5, 0.9, 0.25e-3).tau;
    assert_true(narrow > 900.0 - 400.0 / CLOD_PEAK_BINS && narrow <= 900.0 + 1e-9);
}

// Half of the samples far more densely spaced: the mean goes by the way, not by their number.
static void dense_samples_count_no_more(void **state)
{
    (void)state;
    clod_peak self;
    clod_peak_init(&self, WINDOW, BEYOND);
    clod_peak_add(&self, 0.0, 0.0, 0.0);
    for (int k = 1; k <= 1000; k++) { // 0 to 0.5 mm at 100 Pa, sigma 1
        clod_peak_add(&self, k * 0.5e-6, 100.0, 1.0);
    }
    for (int k = 1; k <= 11; k++) { // 0.5 to 1.05 mm at 200 Pa, sigma 3
        clod_peak_add(&self, 0.5e-3 + k * 5e-5, 200.0, 3.0);
    }
    const clod_peak_result found = clod_peak_summary(&self);
    assert_true(fabs(found.tau - 150.0) < 1e-9 && fabs(found.sigma - 2.0) < 1e-12);
    assert_true(fabs(found.displacement - 0.5e-3) < 1e-12);
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
        cmocka_unit_test(a_triangle_is_lowered_by_the_window),
        cmocka_unit_test(a_spike_counts_by_its_way),
        cmocka_unit_test(dense_samples_count_no_more),
        cmocka_unit_test(before_a_window_is_full),
        cmocka_unit_test(bytes_are_enough),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
