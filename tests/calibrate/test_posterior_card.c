/**
 * The place of a card, and separate answers. Expected: by hand from samples that are put in.
 */

#include "calibrate/posterior_card.h"
#include "plan_made.h"
#include "support/check.h"

#define COUNT 400

static double samples[COUNT];
static clod_posterior_parameter parameter;
static clod_posterior of = {
    .dimensions = 1, .parameters = &parameter, .samples = samples, .count = COUNT};

/** So many samples, spread evenly over an interval. */
static void fill(size_t from, size_t to, double low, double high)
{
    for (size_t i = from; i < to; i++) {
        samples[i] = low + (high - low) * ((double)(i - from) + 0.5) / (double)(to - from);
    }
}

static void two_groups_are_told(void **state)
{
    (void)state;
    clod_posterior_split found;
    fill(0, 100, 0.1, 0.3);
    fill(100, COUNT, 0.7, 0.9);
    assert_true(clod_posterior_is_split(&of, 0, &found));
    check_close(found.share, 0.25, 1e-12);
    check_close(found.below, 0.2, 1e-12);
    check_close(found.above, 0.8, 1e-12);
}

static void one_group_is_none(void **state)
{
    (void)state;
    clod_posterior_split found;
    fill(0, COUNT, 0.0, 1.0);
    assert_false(clod_posterior_is_split(&of, 0, &found));
    fill(0, COUNT, 0.5, 0.58);
    assert_false(clod_posterior_is_split(&of, 0, &found));
    fill(0, 10, 0.1, 0.15); // a fortieth
    fill(10, COUNT, 0.6, 0.8);
    assert_false(clod_posterior_is_split(&of, 0, &found));
    fill(0, 300, 0.1, 0.4); // four in each twentieth between, where the lesser side has 25
    fill(300, 316, 0.4, 0.6);
    fill(316, COUNT, 0.6, 0.75);
    assert_false(clod_posterior_is_split(&of, 0, &found));
}

#define POINTS 36

/** A posterior of runs at points all over a square, each with the number that a formula gives. */
static clod_posterior *make(plan_made *made, double (*formula)(double u, double v))
{
    static double places[POINTS][2], results[POINTS];
    for (int i = 0; i < POINTS; i++) {
        places[i][0] = (i + 0.5) / POINTS;
        places[i][1] = fmod(0.618034 * i, 1.0); // the golden section: no two alike
        results[i] = formula(places[i][0], places[i][1]);
    }
    made->plan.seeds = 1;
    const clod_posterior_runs runs = {&made->plan, POINTS, places[0], results, NULL};
    clod_status status = {CLOD_OK, ""};
    clod_posterior *self = clod_posterior_create(&runs, &status);
    assert_non_null(self);
    assert_false(self->apart);
    return self;
}

static double product(double u, double v)
{
    return u * v;
}

/** u v = 0.2 is a ridge on which u has the density 1/u from 0.2 to 1, and the mean 0.8/log 5 = 0.497, and so has v. The
 *  product of the means is 0.247, twelve errors off. */
static void a_card_of_a_bent_ridge_lies_on_it(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 2, 1);
    made.targets[0].value = 0.2;
    made.targets[0].error = 0.004;
    clod_posterior *self = make(&made, product);
    check_close(self->parameters[0].mean, 0.497, 0.03);
    check_close(self->parameters[1].mean, 0.497, 0.03);
    assert_false(self->card_is_mean);
    check_close(self->card[0] * self->card[1], 0.2, 0.004);
    check_close(self->targets[0].at_card, self->card[0] * self->card[1], 0.004);
    check_close(self->card[0], self->parameters[0].mean, 0.1); // (0.447, 0.447) is nearest
    check_close(self->card[1], self->parameters[1].mean, 0.1);
    clod_posterior_destroy(&self);
}

static double sum(double u, double v)
{
    return u + v;
}

/** u + v = 1 is a straight ridge, with the means on it. */
static void a_card_of_a_straight_ridge_has_the_means(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 2, 1);
    made.targets[0].value = 1.0;
    made.targets[0].error = 0.05;
    clod_posterior *self = make(&made, sum);
    assert_true(self->card_is_mean);
    for (size_t k = 0; k < 2; k++) {
        check_close(self->card[k], self->parameters[k].mean, 0.0);
    }
    check_close(self->targets[0].at_card, 1.0, 0.03);
    clod_posterior_destroy(&self);
}

static double hump(double u, double v)
{
    (void)v;
    return 4.0 * u * (1.0 - u);
}

/** 4 u (1 - u) = 0.64 at u = 0.2 and 0.8, and 1 at the mean. */
static void a_card_between_two_answers_is_one_of_them(void **state)
{
    (void)state;
    plan_made made;
    plan_make(&made, 2, 1);
    made.targets[0].value = 0.64;
    made.targets[0].error = 0.02;
    clod_posterior *self = make(&made, hump);
    clod_posterior_split found;
    assert_true(clod_posterior_is_split(self, 0, &found));
    check_close(found.share, 0.5, 0.1);
    check_close(found.below, 0.2, 0.01);
    check_close(found.above, 0.8, 0.01);
    assert_false(clod_posterior_is_split(self, 1, &found));
    assert_false(self->card_is_mean);
    check_close(hump(self->card[0], 0.0), 0.64, 0.02);
    clod_posterior_destroy(&self);
}

static double line(double u, double v)
{
    (void)v;
    return 1.0 + 0.1 * u;
}

/** A target far from what any place gives, whose error is estimated from three specimens: all places miss it alike, so the
 *  means are as good as a sample, however large the errors are that are drawn with the samples. */
static void a_card_that_misses_alike_everywhere_has_the_means(void **state)
{
    (void)state;
    for (int far = 0; far < 2; far++) {
        plan_made made;
        plan_make(&made, 2, 1);
        clod_plan_target *target = &made.targets[0];
        target->value = far == 0 ? 1.4 : 0.5;
        target->error = 0.05;
        target->repeats.count = 3;
        target->repeats.estimate = true;
        for (int k = 0; k < 3; k++) {
            target->repeats.differences[k] = (clod_plan_difference){101 + k, 0.087 * (k - 1)};
        }
        clod_posterior *self = make(&made, line);
        assert_true(self->card_is_mean);
        clod_posterior_destroy(&self);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_groups_are_told),
        cmocka_unit_test(one_group_is_none),
        cmocka_unit_test(a_card_of_a_bent_ridge_lies_on_it),
        cmocka_unit_test(a_card_of_a_straight_ridge_has_the_means),
        cmocka_unit_test(a_card_between_two_answers_is_one_of_them),
        cmocka_unit_test(a_card_that_misses_alike_everywhere_has_the_means),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
