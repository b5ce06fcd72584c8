/**
 * Draws of what a surrogate does not know. Expected: moments over a grid of the likelihood, or over random places,
 * which test_surrogate.c and test_surrogate_noise.c have written out; chi-square moments of the variance.
 */

#include <gsl/gsl_sf_psi.h>
#include <math.h>

#include "base/random.h"
#include "calibrate/surrogate.h"
#include "support/check.h"
#include "support/sanitized.h"

#define RUNS 24
#define DRAWS 1500

static double inputs[RUNS], results[RUNS];
static clod_surrogate *draws[DRAWS];

/** A wave with packings that scatter: two of each point, one of each where `points` is RUNS. */
static clod_surrogate *fit(int runs, int points, clod_surrogate_kind kind)
{
    clod_status status = {CLOD_OK, ""};
    for (int i = 0; i < runs; i++) {
        inputs[i] = ((double)(i % points) + 0.5) / points;
        results[i] = sin(4.0 * inputs[i]) +
                     0.1 * clod_random_normal(7, CLOD_RANDOM_TEST, (uint64_t)i, 0);
    }
    const clod_surrogate_runs all = {1, (size_t)runs, inputs, results, NULL};
    clod_surrogate *self = clod_surrogate_create(&all, kind, &status);
    assert_non_null(self);
    return self;
}

static void draw(const clod_surrogate *self)
{
    clod_status status = {CLOD_OK, ""};
    const clod_surrogate_dice dice = {11, 500};
    double effective;
    assert_true(clod_surrogate_draw(self, &dice, DRAWS, NULL, draws, &effective, &status));
}

static void destroy(clod_surrogate *self)
{
    clod_surrogate_destroy(&self);
    for (int i = 0; i < DRAWS; i++) {
        clod_surrogate_destroy(&draws[i]);
    }
}

/** Mean and mean square of numbers with weights. */
typedef struct moments {
    double weight, mean, square;
} moments;

static void add(moments *self, double value, double square, double weight)
{
    self->weight += weight;
    self->mean += weight * (value - self->mean) / self->weight;
    self->square += weight * (square - self->square) / self->weight;
}

static double deviation(const moments *self)
{
    return sqrt(self->square - self->mean * self->mean);
}

/** Logarithms of the length and of the noise's variance in the middle, and the slope. */
static void look(const clod_surrogate *self, double *numbers)
{
    const double middle = 0.5;
    numbers[0] = log(clod_surrogate_length(self, 0));
    numbers[1] = 2.0 * log(clod_surrogate_noise(self, &middle));
    numbers[2] = clod_surrogate_slope(self, 0);
}

#define GRID 40

/** The same over the ranges of length (0.1 to 10), nugget (1e-6 to 1e4) and slope (-6 to 6) by their likelihood. With f
 *  degrees the variance is f s^2/chi-square: its logarithm's mean is that of f s^2 less digamma(f/2) + log 2, and its
 *  variance trigamma(f/2). */
static void weigh(double freedom, moments *of)
{
    const clod_surrogate_runs all = {1, RUNS, inputs, results, NULL};
    for (int i = 0; i < GRID * GRID * GRID; i++) {
        const clod_surrogate_hyper hyper = {
            .lengths = {0.1 * pow(100.0, (i % GRID + 0.5) / GRID)},
            .nugget = 1e-6 * pow(1e10, (i / GRID % GRID + 0.5) / GRID),
            .slopes = {-6.0 + 12.0 * (i / GRID / GRID + 0.5) / GRID}};
        clod_status status = {CLOD_OK, ""};
        clod_surrogate *one =
            clod_surrogate_create_at(&all, CLOD_SURROGATE_GAUSSIAN, &hyper, &status);
        assert_non_null(one);
        double numbers[3];
        look(one, numbers);
        numbers[1] += log(freedom) - gsl_sf_psi(0.5 * freedom) - log(2.0);
        const double own[] = {0.0, gsl_sf_psi_1(0.5 * freedom), 0.0};
        for (int k = 0; k < 3; k++) {
            add(&of[k], numbers[k], numbers[k] * numbers[k] + own[k],
                exp(clod_surrogate_likelihood(one)));
        }
        clod_surrogate_destroy(&one);
    }
}

/** Of 1500 draws at least 300 count as independent: means are known to 0.06 deviations, deviations to 0.05; three of
 *  them and the grid's coarseness are allowed. */
static void draws_have_the_moments_of_the_likelihood(void **state)
{
    (void)state;
    if (sanitized()) {
        skip(); // moments do not depend on the build; those below draw too
    }
    clod_surrogate *self = fit(RUNS, RUNS / 2, CLOD_SURROGATE_GAUSSIAN);
    moments expected[3] = {{0.0, 0.0, 0.0}};
    moments found[3] = {{0.0, 0.0, 0.0}};
    weigh(RUNS - 2.0, expected);
    draw(self);
    for (int i = 0; i < DRAWS; i++) {
        double numbers[3];
        look(draws[i], numbers);
        for (int k = 0; k < 3; k++) {
            add(&found[k], numbers[k], numbers[k] * numbers[k], 1.0);
        }
    }
    for (int k = 0; k < 3; k++) {
        const double one = deviation(&expected[k]);
        print_message("%.3f +- %.3f, expected %.3f +- %.3f\n", found[k].mean,
                      deviation(&found[k]), expected[k].mean, one);
        check_close(found[k].mean, expected[k].mean, 0.2 * one);
        check_close(deviation(&found[k]), one, 0.2 * one);
    }
    destroy(self);
}

#define FOUR 4             ///< parameters
#define NUMBERS (2 * FOUR) ///< lengths and slopes that are looked at
#define STREAMS 5
#define PLACES 100000

/** Two packings of twelve points of four parameters: a wave along each, flatter and flatter. */
static clod_surrogate_runs four(void)
{
    static double places[RUNS * FOUR];
    for (int i = 0; i < RUNS; i++) {
        results[i] = 0.1 * clod_random_normal(7, CLOD_RANDOM_TEST, (uint64_t)i, 0);
        for (int k = 0; k < FOUR; k++) {
            const double at =
                clod_random_uniform(5, CLOD_RANDOM_TEST, (uint64_t)(i / 2), (uint64_t)k);
            places[FOUR * i + k] = at;
            results[i] += sin((2.0 + k) * at) / (1.0 + k);
        }
    }
    return (clod_surrogate_runs){FOUR, RUNS, places, results, NULL};
}

static void look_at_four(const clod_surrogate *self, double *numbers)
{
    for (size_t k = 0; k < FOUR; k++) {
        numbers[k] = log(clod_surrogate_length(self, k));
        numbers[FOUR + k] = clod_surrogate_slope(self, k);
    }
}

/** Random places in the ranges, lengths 0.1 to 10, nugget 1e-6 to 1e4, slopes -3 to 3 (four deviations of 1.5/sqrt 4),
 *  each with its likelihood as its weight. */
static void weigh_four(const clod_surrogate_runs *runs, moments *of)
{
    double squares = 0.0; // of the weights: so few places may count that they tell nothing
    for (int i = 0; i < PLACES; i++) {
        clod_surrogate_hyper hyper = {.nugget = 1e-6};
        for (uint64_t k = 0; k < FOUR; k++) {
            const uint64_t item = (uint64_t)i;
            hyper.lengths[k] =
                0.1 * pow(100.0, clod_random_uniform(9, CLOD_RANDOM_TEST, item, k));
            hyper.slopes[k] =
                -3.0 + 6.0 * clod_random_uniform(9, CLOD_RANDOM_TEST, item, FOUR + k);
        }
        hyper.nugget *= pow(1e10, clod_random_uniform(9, CLOD_RANDOM_TEST, (uint64_t)i, 50));
        clod_status status = {CLOD_OK, ""};
        clod_surrogate *one =
            clod_surrogate_create_at(runs, CLOD_SURROGATE_GAUSSIAN, &hyper, &status);
        if (one == NULL) {
            continue; // not positive definite: no draw is there either
        }
        double numbers[NUMBERS];
        const double weight = exp(clod_surrogate_likelihood(one));
        look_at_four(one, numbers);
        for (int k = 0; k < NUMBERS; k++) {
            add(&of[k], numbers[k], numbers[k] * numbers[k], weight);
        }
        squares += weight * weight;
        clod_surrogate_destroy(&one);
    }
    const double count = of[0].weight * of[0].weight / squares;
    print_message("%.0f of the random places count\n", count);
    assert_true(count > 60.0);
}

/** As many draws as a calibration has, five times over. Some 100 of the random places count and at least 80 of the draws:
 *  a mean is known to 0.15 deviations, of eight the farthest off is so by 2.5 of that. A chain a tenth as long was 0.3 to
 *  0.5 deviations off in half of them, on the same side. */
static void few_draws_of_four_parameters_have_the_moments(void **state)
{
    (void)state;
    if (sanitized()) {
        skip(); // moments do not depend on the build; those below draw too
    }
    const clod_surrogate_runs runs = four();
    clod_status status = {CLOD_OK, ""};
    clod_surrogate *self = clod_surrogate_create(&runs, CLOD_SURROGATE_GAUSSIAN, &status);
    assert_non_null(self);
    moments expected[NUMBERS] = {{0.0, 0.0, 0.0}};
    moments found[NUMBERS] = {{0.0, 0.0, 0.0}};
    weigh_four(&runs, expected);
    for (uint64_t stream = 0; stream < STREAMS; stream++) {
        const clod_surrogate_dice dice = {1, 1000 + 2 * stream};
        double effective;
        assert_true(clod_surrogate_draw(self, &dice, 64, NULL, draws, &effective, &status));
        assert_true(effective >= 16.0 && effective <= 64.0);
        for (int i = 0; i < 64; i++) {
            double numbers[NUMBERS];
            look_at_four(draws[i], numbers);
            for (int k = 0; k < NUMBERS; k++) {
                add(&found[k], numbers[k], numbers[k] * numbers[k], 1.0);
            }
            clod_surrogate_destroy(&draws[i]);
        }
    }
    double square = 0.0;
    for (int k = 0; k < NUMBERS; k++) {
        const double one = deviation(&expected[k]);
        const double off = (found[k].mean - expected[k].mean) / one;
        print_message("%.3f +- %.3f, expected %.3f +- %.3f: %+.2f\n", found[k].mean,
                      deviation(&found[k]), expected[k].mean, one, off);
        assert_true(fabs(off) < 0.38);
        square += off * off / NUMBERS;
    }
    assert_true(sqrt(square) < 0.22);
    clod_surrogate_destroy(&self);
}

/** Means over 64 draws of 24 streams scatter as those of as many independent draws as are told: the mean told is 64 over
 *  the largest variance of means in units of a draw's variance over 64. A variance of 24 is known to 0.3, the largest of
 *  nine is some 0.4 above its expectation, and a stream tells its own number to a third: a factor of two is allowed. */
static void independent_draws_tell_how_far_means_scatter(void **state)
{
    (void)state;
    if (sanitized()) {
        skip(); // moments do not depend on the build; those below draw too
    }
    enum { MANY = 24, EACH = 64 };
    const clod_surrogate_runs runs = four();
    clod_status status = {CLOD_OK, ""};
    clod_surrogate *self = clod_surrogate_create(&runs, CLOD_SURROGATE_GAUSSIAN, &status);
    assert_non_null(self);
    moments means[NUMBERS + 1] = {{0.0, 0.0, 0.0}};
    moments all[NUMBERS + 1] = {{0.0, 0.0, 0.0}};
    double told = 0.0;
    for (uint64_t stream = 0; stream < MANY; stream++) {
        const clod_surrogate_dice dice = {2, 5000 + 2 * stream};
        double effective;
        moments here[NUMBERS + 1] = {{0.0, 0.0, 0.0}};
        assert_true(clod_surrogate_draw(self, &dice, EACH, NULL, draws, &effective, &status));
        told += effective / MANY;
        for (int i = 0; i < EACH; i++) {
            double numbers[NUMBERS + 1];
            look_at_four(draws[i], numbers);
            const double middle[FOUR] = {0.5, 0.5, 0.5, 0.5};
            numbers[NUMBERS] = 2.0 * log(clod_surrogate_noise(draws[i], middle));
            for (int k = 0; k <= NUMBERS; k++) {
                add(&here[k], numbers[k], numbers[k] * numbers[k], 1.0);
                add(&all[k], numbers[k], numbers[k] * numbers[k], 1.0);
            }
            clod_surrogate_destroy(&draws[i]);
        }
        for (int k = 0; k <= NUMBERS; k++) {
            add(&means[k], here[k].mean, here[k].mean * here[k].mean, 1.0);
        }
    }
    double largest = 0.0;
    for (int k = 0; k <= NUMBERS; k++) {
        const double ratio = deviation(&means[k]) / deviation(&all[k]);
        largest = fmax(largest, ratio * ratio * EACH * MANY / (MANY - 1.0));
    }
    print_message("told %.1f independent draws of %d, means scatter as those of %.1f\n", told,
                  EACH, EACH / largest);
    assert_true(told < 0.9 * EACH); // else nothing is asked
    assert_true(told * largest / EACH > 0.5 && told * largest / EACH < 2.0);
    clod_surrogate_destroy(&self);
}

/** Four runs and a line leave two degrees, too few for slopes: what a line does not know is Student's t. The middle of
 *  s^2 f/v over draws is the median of chi-square of two degrees, 2 log 2; its share below it scatters by 0.013. */
static void the_variance_of_a_line_is_drawn(void **state)
{
    (void)state;
    clod_surrogate *self = fit(4, 4, CLOD_SURROGATE_LINEAR);
    const double middle = 0.5;
    const double likeliest = clod_surrogate_noise(self, &middle);
    draw(self);
    int below = 0, tail = 0;
    for (int i = 0; i < DRAWS; i++) {
        assert_true(clod_surrogate_slope(draws[i], 0) == 0.0);
        const double over = likeliest / clod_surrogate_noise(draws[i], &middle);
        below += 2.0 * over * over < 2.0 * log(2.0) ? 1 : 0;
        tail += 2.0 * over * over < -2.0 * log(0.95) ? 1 : 0; // 5 % of chi-square
    }
    check_close((double)below / DRAWS, 0.5, 0.05);
    check_close((double)tail / DRAWS, 0.05, 0.02);
    destroy(self);
}

/** The variance's dice are one in each 64th of their range: of 64 draws as many are below each quantile as should be, but
 *  for one, where independent ones scatter by four. */
static void the_variance_is_drawn_evenly(void **state)
{
    (void)state;
    clod_surrogate *self = fit(4, 4, CLOD_SURROGATE_LINEAR);
    clod_status status = {CLOD_OK, ""};
    const double middle = 0.5;
    const double likeliest = clod_surrogate_noise(self, &middle);
    for (uint64_t stream = 0; stream < 20; stream++) {
        const clod_surrogate_dice dice = {3, 2 * stream};
        double effective;
        assert_true(clod_surrogate_draw(self, &dice, 64, NULL, draws, &effective, &status));
        assert_true(effective == 64.0);
        int below[4] = {0, 0, 0, 0}; // an eighth, a quarter, half, seven eighths
        int rises = 0;
        double last = 0.0;
        for (int i = 0; i < 64; i++) {
            const double over = likeliest / clod_surrogate_noise(draws[i], &middle);
            static const double SHARES[] = {0.125, 0.25, 0.5, 0.875};
            for (int k = 0; k < 4; k++) {
                below[k] += 2.0 * over * over < -2.0 * log(1.0 - SHARES[k]) ? 1 : 0;
            }
            rises += over > last ? 1 : 0;
            last = over;
            clod_surrogate_destroy(&draws[i]);
        }
        assert_in_range(below[0], 7, 9);
        assert_in_range(below[1], 15, 17);
        assert_in_range(below[2], 31, 33);
        assert_in_range(below[3], 55, 57);
        assert_in_range(rises, 22, 42); // in random order
    }
    clod_surrogate_destroy(&self);
}

/** The same dice, the same draws; other dice, others. */
static void draws_follow_their_dice(void **state)
{
    (void)state;
    clod_status status = {CLOD_OK, ""};
    clod_surrogate *self = fit(RUNS, RUNS, CLOD_SURROGATE_GAUSSIAN);
    clod_surrogate *some[3][4];
    const clod_surrogate_dice dice[] = {{1, 10}, {1, 10}, {1, 12}};
    double effective;
    for (int k = 0; k < 3; k++) {
        assert_true(clod_surrogate_draw(self, &dice[k], 4, NULL, some[k], &effective, &status));
    }
    for (int i = 0; i < 4; i++) {
        double one[3], same[3], other[3];
        look(some[0][i], one);
        look(some[1][i], same);
        look(some[2][i], other);
        assert_memory_equal(one, same, sizeof one);
        assert_true(other[1] != one[1]);
    }
    for (int k = 0; k < 12; k++) {
        clod_surrogate_destroy(&some[k / 4][k % 4]);
    }
    clod_surrogate_destroy(&self);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(draws_have_the_moments_of_the_likelihood),
        cmocka_unit_test(few_draws_of_four_parameters_have_the_moments),
        cmocka_unit_test(independent_draws_tell_how_far_means_scatter),
        cmocka_unit_test(the_variance_of_a_line_is_drawn),
        cmocka_unit_test(the_variance_is_drawn_evenly),
        cmocka_unit_test(draws_follow_their_dice),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
