/**
 * Populations drawn from densities. Expected: shares and moments of the densities, in closed form.
 */

#include "calibrate/population.h"
#include "support/check.h"

#define COUNT 2000
#define SEEDS 50

/** Logarithm of the sum of two logarithms. */
static double both(double a, double b)
{
    return fmax(a, b) + log1p(exp(-fabs(a - b)));
}

/** Normal about (x, y) with this deviation and weight, in two dimensions. */
static double hill(const double *u, double x, double y, double deviation, double weight)
{
    const double away = hypot(u[0] - x, u[1] - y) / deviation;
    return log(weight) - 2.0 * log(deviation) - 0.5 * away * away;
}

/** Two summits, the narrow one with three tenths. */
static double two_summits(void *context, const double *u, const size_t *choices)
{
    (void)context;
    (void)choices;
    return both(hill(u, 0.2, 0.2, 0.02, 0.3), hill(u, 0.75, 0.7, 0.06, 0.7));
}

static void make(const clod_chain_setup *setup, clod_population *self)
{
    clod_status status;
    assert_true(clod_population_create(setup, COUNT, self, &status));
    assert_int_equal(self->count, COUNT);
}

/** Share of the members whose first coordinate is below. */
static double share_below(const clod_population *self, double at)
{
    double share = 0.0;
    for (size_t i = 0; i < COUNT; i++) {
        share += self->places[2 * i] < at ? 1.0 / COUNT : 0.0;
    }
    return share;
}

/** Each of 50 populations, and their mean. Some 20 of 2000 random places lie within three deviations of the narrow summit
 *  (2000 pi 0.06^2 = 23), so its share is known to a fifth, 0.06; of the mean to 0.01. */
static void summits_have_their_shares(void **state)
{
    (void)state;
    clod_chain_setup setup = {.dimensions = 2, .chains = 4, .density = two_summits};
    double mean = 0.0;
    for (setup.seed = 1; setup.seed <= SEEDS; setup.seed++) {
        clod_population self;
        make(&setup, &self);
        const double share = share_below(&self, 0.45);
        check_close(share, 0.3, 0.25);
        mean += share / SEEDS;
        for (size_t i = 0; i < COUNT; i++) {
            check_close(self.density[i], two_summits(NULL, self.places + 2 * i, NULL), 0.0);
        }
        clod_population_fini(&self);
    }
    check_close(mean, 0.3, 0.03);
}

/** A wide hill, and a needle with all of the mass but 1e-14 that five of 2000 random places are near to. */
static double hill_and_needle(void *context, const double *u, const size_t *choices)
{
    (void)context;
    (void)choices;
    const double a = hypot(u[0] - 0.85, u[1] - 0.85) / 0.0035;
    const double b = hypot(u[0] - 0.3, u[1] - 0.3) / 0.1;
    return fmax(40.0 - 0.5 * a * a, -0.5 * b * b);
}

static void a_needle_is_found(void **state)
{
    (void)state;
    clod_chain_setup setup = {.dimensions = 2, .chains = 4, .density = hill_and_needle};
    int found = 0;
    for (setup.seed = 1; setup.seed <= SEEDS; setup.seed++) {
        clod_population self;
        make(&setup, &self);
        found += share_below(&self, 0.6) == 0.0 ? 1 : 0;
        clod_population_fini(&self);
    }
    assert_true(found >= SEEDS - 2);
}

/** A ring of radius 0.3, 0.006 wide: each coordinate has the mean 0.5 and the variance 0.3^2/2. */
static double ring(void *context, const double *u, const size_t *choices)
{
    (void)context;
    (void)choices;
    const double away = (hypot(u[0] - 0.5, u[1] - 0.5) - 0.3) / 0.006;
    return -0.5 * away * away;
}

static void a_bent_ridge_is_filled(void **state)
{
    (void)state;
    const clod_chain_setup setup = {.dimensions = 2, .chains = 4, .density = ring, .seed = 3};
    clod_population self;
    make(&setup, &self);
    for (size_t k = 0; k < 2; k++) {
        double mean = 0.0, square = 0.0;
        for (size_t i = 0; i < COUNT; i++) {
            const double away = self.places[2 * i + k] - 0.5;
            mean += away / COUNT;
            square += away * away / COUNT;
        }
        check_close(mean, 0.0, 0.03);
        check_relative(square, 0.045, 0.1);
    }
    clod_population_fini(&self);
}

/** Only with these whole numbers there is a density at all. */
static double with_two_and_three(void *context, const double *u, const size_t *choices)
{
    (void)context;
    const double x = (u[0] - 0.4) / 0.05;
    return choices[0] == 2 && choices[1] == 3 && choices[2] == 1 ? -0.5 * x * x : -HUGE_VAL;
}

/** One of 64 triples, which 31 of 2000 random members have. */
static void members_have_their_whole_numbers(void **state)
{
    (void)state;
    const clod_chain_setup setup = {.dimensions = 2,
                                    .chains = 4,
                                    .choices = 3,
                                    .options = 4,
                                    .seed = 6,
                                    .density = with_two_and_three};
    clod_population self;
    make(&setup, &self);
    double mean = 0.0;
    for (size_t i = 0; i < COUNT; i++) {
        assert_int_equal(self.chosen[3 * i], 2);
        assert_int_equal(self.chosen[3 * i + 1], 3);
        assert_int_equal(self.chosen[3 * i + 2], 1);
        mean += self.places[2 * i] / COUNT;
    }
    check_close(mean, 0.4, 0.01);
    clod_population_fini(&self);
}

static double none(void *context, const double *u, const size_t *choices)
{
    (void)context;
    (void)u;
    (void)choices;
    return -HUGE_VAL;
}

static bool asked(void *context)
{
    return --*(int *)context <= 0;
}

static void without_density_or_after_a_stop_it_comes_to_an_end(void **state)
{
    (void)state;
    clod_chain_setup setup = {.dimensions = 2, .chains = 4, .density = none};
    clod_population self;
    make(&setup, &self);
    clod_population_fini(&self);
    int left = 3000; // densities: behind the first 2000, before the last
    const clod_stop stop = {asked, &left};
    clod_status status;
    setup.density = two_summits;
    setup.stop = &stop;
    assert_false(clod_population_create(&setup, COUNT, &self, &status));
    assert_int_equal(status.code, CLOD_INTERRUPTED);
    clod_population_fini(&self);
}

/** The way back from a step has the members exchanged, so each is as likely; a leap is the whole difference. */
static void steps_go_along_differences(void **state)
{
    (void)state;
    double places[] = {0.1, 0.1, 0.3, 0.4, 0.8, 0.2};
    const clod_population self = {.count = 3, .places = places};
    const double from[] = {0.5, 0.5};
    double next[2];
    const clod_population_dice leap = {0.5, 0.1, 0.1}; // the second less the first
    assert_true(clod_population_propose(&self, 2, &leap, from, next));
    check_close(next[0], 0.7, 1e-15);
    check_close(next[1], 0.8, 1e-15);
    const clod_population_dice back = {0.1, 0.1, 0.1}; // the first less the second
    assert_true(clod_population_propose(&self, 2, &back, next, next));
    check_close(next[0], 0.5, 1e-15);
    check_close(next[1], 0.5, 1e-15);
    const clod_population_dice out = {0.9, 0.1, 0.1}; // the third less the first
    assert_false(clod_population_propose(&self, 2, &out, from, next));
    const clod_population_dice narrow = {0.5, 0.1, 1.0}; // 2.38/2 of a hundredth
    assert_true(clod_population_propose(&self, 2, &narrow, from, next));
    check_close(next[0], 0.5 + 0.0119 * 0.2, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(summits_have_their_shares),
        cmocka_unit_test(a_needle_is_found),
        cmocka_unit_test(a_bent_ridge_is_filled),
        cmocka_unit_test(members_have_their_whole_numbers),
        cmocka_unit_test(without_density_or_after_a_stop_it_comes_to_an_end),
        cmocka_unit_test(steps_go_along_differences),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
