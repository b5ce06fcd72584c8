/**
 * Noise of packings that grows over the ranges. Expected: weighted least squares by hand; restricted likelihoods
 * in closed form, written out here once more; the growth that was put in.
 */

#include <string.h>

#include "base/random.h"
#include "calibrate/surrogate.h"
#include "support/check.h"

#define MOST 96

static double room[4 * MOST];

static clod_surrogate *create(const clod_surrogate_runs *runs, clod_surrogate_kind kind)
{
    clod_status status = {CLOD_OK, ""};
    clod_surrogate *self = clod_surrogate_create(runs, kind, &status);
    assert_non_null(self);
    return self;
}

/** Sums of a weighted line through runs of one input, with weights exp(-slope (u - 1/2)). */
typedef struct line {
    double w, wu, wuu, wy, wuy, logs, mean; ///< `mean`: of the growths, 1/weight
    double slope, intercept, square;        ///< least squares, and what they leave
} line;

static line weigh(const clod_surrogate_runs *runs, double slope)
{
    line self;
    memset(&self, 0, sizeof self);
    for (size_t i = 0; i < runs->count; i++) {
        const double u = runs->inputs[i], y = runs->results[i];
        const double w = exp(-slope * (u - 0.5));
        self.w += w;
        self.wu += w * u;
        self.wuu += w * u * u;
        self.wy += w * y;
        self.wuy += w * u * y;
        self.logs -= log(w);
        self.mean += 1.0 / w / (double)runs->count;
    }
    const double determinant = self.w * self.wuu - self.wu * self.wu;
    self.slope = (self.w * self.wuy - self.wu * self.wy) / determinant;
    self.intercept = (self.wy - self.slope * self.wu) / self.w;
    for (size_t i = 0; i < runs->count; i++) {
        const double u = runs->inputs[i];
        const double off = runs->results[i] - self.intercept - self.slope * u;
        self.square += exp(-slope * (u - 0.5)) * off * off;
    }
    return self;
}

/** Restricted log likelihood of a line (Harville, J. Am. Stat. Assoc. 72 (1977) 320), with the log prior of a
 *  slope whose standard deviation is 1.5. */
static double likelihood(const clod_surrogate_runs *runs, double slope)
{
    const line of = weigh(runs, slope);
    const double freedom = (double)runs->count - 2.0;
    return -0.5 * (freedom * log(of.square / freedom) + of.logs +
                   log(of.w * of.wuu - of.wu * of.wu) + slope * slope / (1.5 * 1.5));
}

static void a_line_is_that_of_weighted_least_squares(void **state)
{
    (void)state;
    const double u[] = {0.0, 0.0, 0.5, 0.5, 1.0, 1.0};
    const double y[] = {1.0, 1.1, 2.3, 1.9, 2.0, 4.0};
    const clod_surrogate_runs runs = {1, 6, u, y, NULL};
    const clod_surrogate_hyper hyper = {.slopes = {2.0}};
    clod_status status = {CLOD_OK, ""};
    clod_surrogate *self =
        clod_surrogate_create_at(&runs, CLOD_SURROGATE_LINEAR, &hyper, &status);
    assert_non_null(self);
    const line of = weigh(&runs, 2.0);
    const double variance = of.square / 4.0;
    const double determinant = of.w * of.wuu - of.wu * of.wu;
    for (double at = 0.0; at <= 1.0; at += 0.25) {
        const double growth = exp(2.0 * (at - 0.5));
        // h' (H' W H)^-1 h of the line, and what runs are off it: on the average, or there if that is more
        const double spread = (of.wuu - 2.0 * at * of.wu + at * at * of.w) / determinant;
        const clod_surrogate_value told = clod_surrogate_at(self, &at, room);
        check_close(told.mean, of.intercept + of.slope * at, 1e-12);
        check_close(told.variance, variance * (spread + fmax(of.mean, growth)), 1e-12);
        check_close(clod_surrogate_noise(self, &at), sqrt(variance * growth), 1e-12);
    }
    double least, greatest;
    clod_surrogate_noise_ends(self, &least, &greatest);
    check_close(least, sqrt(variance * exp(-1.0)), 1e-12);
    check_close(greatest, sqrt(variance * exp(1.0)), 1e-12);
    // of runs with the noise of their place: 2.0 is so far off over the noise at the upper end
    double off[8];
    assert_true(clod_surrogate_residuals(self, off));
    check_close(off[4], (2.0 - of.intercept - of.slope) / exp(0.5), 1e-12);
    check_close(clod_surrogate_noise_of(self, 4), sqrt(variance * exp(1.0)), 1e-12);
    clod_surrogate_destroy(&self);
}

/** Runs about a line at `points` places, `packings` each: noise 0.1 in the middle, growing by `slope`. */
static void scatter(clod_surrogate_runs *runs, double *u, double *y, size_t packings,
                    double slope, uint64_t set)
{
    for (size_t i = 0; i < runs->count; i++) {
        const size_t points = runs->count / packings, point = i / packings;
        u[i] = ((double)point + 0.5) / (double)points;
        y[i] = 1.0 + u[i] + sin(3.0 * u[i]) +
               0.1 * exp(0.5 * slope * (u[i] - 0.5)) *
                   clod_random_normal(11, CLOD_RANDOM_TEST, 1000 * set + i, 0);
    }
    runs->inputs = u;
    runs->results = y;
}

/** Of slopes on a grid none is likelier than that found, and the likeliest of the grid is next to it. */
static void the_slope_of_a_line_is_the_likeliest(void **state)
{
    (void)state;
    double u[MOST], y[MOST];
    for (uint64_t set = 0; set < 4; set++) {
        clod_surrogate_runs runs = {.dimensions = 1, .count = 18};
        scatter(&runs, u, y, 3, 2.0, set);
        clod_surrogate *self = create(&runs, CLOD_SURROGATE_LINEAR);
        double best = -6.0;
        for (double slope = -6.0; slope <= 6.0; slope += 0.01) {
            best = likelihood(&runs, slope) > likelihood(&runs, best) ? slope : best;
        }
        check_close(clod_surrogate_slope(self, 0), best, 0.05);
        check_close(clod_surrogate_likelihood(self), likelihood(&runs, best), 1e-3);
        clod_surrogate_destroy(&self);
    }
}

#define SETS 20

/** Mean of the slopes found in 20 sets of 32 points of 3 packings, and their scatter. */
static double mean_of(double slope, double *deviation)
{
    double u[MOST], y[MOST], sum = 0.0, square = 0.0;
    for (uint64_t set = 0; set < SETS; set++) {
        clod_surrogate_runs runs = {.dimensions = 1, .count = MOST};
        scatter(&runs, u, y, 3, slope, set);
        clod_surrogate *self = create(&runs, CLOD_SURROGATE_GAUSSIAN);
        sum += clod_surrogate_slope(self, 0);
        square += clod_surrogate_slope(self, 0) * clod_surrogate_slope(self, 0);
        clod_surrogate_destroy(&self);
    }
    *deviation = sqrt((square - sum * sum / SETS) / (SETS - 1));
    return sum / SETS;
}

/**
 * A standard deviation that grows by a factor of 4 is a slope of 2 ln 4 = 2.77. Each of the 92 or so degrees of
 * freedom tells the logarithm of a variance to sqrt 2, and the slope over a uniform design to sqrt(24/92) = 0.51;
 * the prior of 1.5 draws it to 2.77/(1 + (0.51/1.5)^2) = 2.48, and its scatter to 0.46, or 0.10 of the mean of
 * 20: with a noise that does not grow, to 0.
 */
static void the_growth_that_was_put_in_is_found(void **state)
{
    (void)state;
    double deviation;
    check_close(mean_of(2.0 * log(4.0), &deviation), 2.48, 0.3);
    check_close(deviation, 0.46, 0.2);
    check_close(mean_of(0.0, &deviation), 0.0, 0.3);
    check_close(deviation, 0.46, 0.2);
    check_close(mean_of(-2.0 * log(4.0), &deviation), -2.48, 0.3);
}

/** One degree of freedom tells one variance, two tell no growth beside it; three do. */
static void few_runs_tell_no_growth(void **state)
{
    (void)state;
    const double u[] = {0.0, 0.2, 0.5, 1.0, 1.0};
    const double y[] = {0.0, 0.2, 0.51, 1.7, 0.3};
    const clod_surrogate_runs runs = {1, 4, u, y, NULL}, more = {1, 5, u, y, NULL};
    clod_surrogate *self = create(&runs, CLOD_SURROGATE_LINEAR);
    check_close(clod_surrogate_slope(self, 0), 0.0, 0.0);
    clod_surrogate_destroy(&self);
    self = create(&more, CLOD_SURROGATE_LINEAR);
    assert_true(clod_surrogate_slope(self, 0) > 0.5); // only the runs at the upper end scatter
    clod_surrogate_destroy(&self);
}

/** With one degree of freedom the likelihood says nothing of slopes, and the prior is left. From a corner to the
 *  opposite one the log variance has a deviation of 1.5, so of two parameters each has 1.5/sqrt 2. */
static void the_prior_is_that_of_a_diagonal(void **state)
{
    (void)state;
    const double u[][2] = {{0.0, 0.1}, {0.3, 0.9}, {0.6, 0.2}, {1.0, 0.8}};
    const double y[] = {0.0, 0.3, 1.0, 0.7};
    const clod_surrogate_runs runs = {2, 4, u[0], y, NULL};
    static const clod_surrogate_hyper AT[] = {{.slopes = {0.0, 0.0}}, {.slopes = {1.0, -0.5}}};
    double found[2];
    for (int k = 0; k < 2; k++) {
        clod_status status = {CLOD_OK, ""};
        clod_surrogate *self =
            clod_surrogate_create_at(&runs, CLOD_SURROGATE_LINEAR, &AT[k], &status);
        assert_non_null(self);
        found[k] = clod_surrogate_likelihood(self);
        clod_surrogate_destroy(&self);
    }
    check_close(found[1] - found[0], -0.5 * (1.0 + 0.25) / (0.5 * 1.5 * 1.5), 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_is_that_of_weighted_least_squares),
        cmocka_unit_test(the_slope_of_a_line_is_the_likeliest),
        cmocka_unit_test(the_growth_that_was_put_in_is_found),
        cmocka_unit_test(few_runs_tell_no_growth),
        cmocka_unit_test(the_prior_is_that_of_a_diagonal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
