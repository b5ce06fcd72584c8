/**
 * @file test_stop.c
 * A stop is heard in every loop of the fit, the chains and what follows, wherever it comes.
 *
 * Nothing is timed: the asks are counted, and the one that is answered with yes is chosen.
 */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "calibrate/chain.h"
#include "calibrate/study.h"
#include "plan_made.h"

#define POINTS 12
#define NEVER SIZE_MAX
#define AFTER 4 ///< asks behind the first yes: two more starts of the fit, and who called it

/** Asks so far, and the first that is answered with yes. */
typedef struct asker {
    size_t asks, limit;
} asker;

static bool asked(void *context)
{
    asker *self = context;
    return self->asks++ >= self->limit;
}

/** Two curved results of 12 points with two packings each: enough for Gaussian processes. */
static double places[POINTS], results[POINTS * 2 * 2];

static void make_plan(plan_made *made, size_t targets)
{
    plan_make(made, 1, targets);
    for (size_t t = 0; t < targets; t++) {
        made->targets[t].value = 12.0;
        made->targets[t].error = 1.0;
    }
}

static void make_results(size_t points, size_t targets)
{
    for (size_t i = 0; i < points; i++) {
        places[i] = ((double)i + 0.5) / (double)points;
        for (size_t k = 0; k < 2 * targets; k++) { // packings and targets
            results[2 * targets * i + k] =
                10.0 + 5.0 * sin(2.0 * places[i]) + 0.1 * (double)(k / targets);
        }
    }
}

static clod_posterior *make(const plan_made *made, size_t points, asker *who,
                            clod_status *status)
{
    const clod_stop stop = {asked, who};
    const clod_posterior_runs runs = {&made->plan, points, places, results, &stop};
    return clod_posterior_create(&runs, status);
}

static void stop_is_heard_wherever_it_comes(void **state)
{
    (void)state;
    plan_made made;
    clod_status status = {CLOD_OK, ""};
    asker who = {0, NEVER};
    make_plan(&made, 2);
    make_results(POINTS, 2);
    clod_posterior *self = make(&made, POINTS, &who, &status);
    assert_non_null(self);
    clod_posterior_destroy(&self);
    const size_t all = who.asks;
    for (size_t part = 0; part <= 20; part++) {
        who = (asker){0, part * (all - 1) / 20};
        status = (clod_status){CLOD_OK, ""};
        assert_null(make(&made, POINTS, &who, &status));
        assert_int_equal(status.code, CLOD_INTERRUPTED);
        assert_in_range(who.asks, who.limit + 1, who.limit + 1 + AFTER);
    }
}

// Four chains of 250 samples more ask up to 6000 times more, at a normal step, four along differences and a draw of a
// surrogate of each, where the place is within the range, and all their samples, up to 2000, are looked at: another 1000.
// The rest, surrogates, population and warm-up, is the same.
static void stop_is_asked_for_at_every_sample_that_is_looked_at(void **state)
{
    (void)state;
    size_t asks[2];
    for (size_t more = 0; more < 2; more++) {
        plan_made made;
        clod_status status = {CLOD_OK, ""};
        asker who = {0, NEVER};
        make_plan(&made, 1);
        made.plan.sampling.samples = more > 0 ? 500 : 250;
        make_results(POINTS, 1);
        clod_posterior *self = make(&made, POINTS, &who, &status);
        assert_non_null(self);
        clod_posterior_destroy(&self);
        asks[more] = who.asks;
    }
    assert_in_range(asks[1] - asks[0], 4001, 7000);
}

static void stop_is_asked_for_at_every_likelihood_and_every_point_left_out(void **state)
{
    (void)state;
    clod_status status = {CLOD_OK, ""};
    asker who = {0, NEVER};
    const clod_stop stop = {asked, &who};
    double u[POINTS], y[POINTS];
    for (int i = 0; i < POINTS; i++) {
        u[i] = ((double)i + 0.5) / POINTS;
        y[i] = sin(3.0 * u[i]);
    }
    const clod_surrogate_runs runs = {1, POINTS, u, y, &stop};
    clod_surrogate *self = clod_surrogate_create(&runs, CLOD_SURROGATE_GAUSSIAN, &status);
    assert_non_null(self);
    assert_true(who.asks > 3 * 10); // three starts, two hyperparameters
    who.asks = 0;
    clod_surrogate_check check;
    assert_true(clod_surrogate_leave_one_out(self, &stop, &check, &status));
    assert_int_equal(who.asks, POINTS);
    who = (asker){0, POINTS / 2};
    assert_false(clod_surrogate_leave_one_out(self, &stop, &check, &status));
    assert_int_equal(status.code, CLOD_INTERRUPTED);
    assert_int_equal(who.asks, POINTS / 2 + 1);
    clod_surrogate_destroy(&self);
}

static double count_density(void *context, const double *point, const size_t *choices)
{
    (void)point;
    (void)choices;
    ++*(size_t *)context;
    return 0.0;
}

static void chain_asks_before_every_density(void **state)
{
    (void)state;
    size_t densities = 0;
    double samples[4 * 500], accepted;
    asker who = {0, NEVER};
    const clod_stop stop = {asked, &who};
    const double middle = 0.5;
    const clod_chain_setup setup = {.dimensions = 1,
                                    .start = &middle,
                                    .chains = 4,
                                    .warm_up = 300,
                                    .kept = 500,
                                    .seed = 1,
                                    .density = count_density,
                                    .context = &densities,
                                    .stop = &stop};
    assert_true(clod_chain_run(&setup, samples, NULL, &accepted));
    assert_int_equal(who.asks, densities);
    const size_t all = densities;
    for (size_t part = 0; part < 20; part++) {
        densities = 0;
        who = (asker){0, part * all / 20};
        assert_false(clod_chain_run(&setup, samples, NULL, &accepted));
        assert_int_equal(densities, who.limit);
    }
}

static void further_points_ask_at_every_candidate(void **state)
{
    (void)state;
    plan_made made;
    clod_status status = {CLOD_OK, ""};
    asker who = {0, NEVER};
    const clod_stop stop = {asked, &who};
    double next[3];
    make_plan(&made, 1);
    make_results(POINTS, 1);
    clod_posterior *self = make(&made, POINTS, &who, &status);
    assert_non_null(self);
    who.asks = 0;
    assert_true(clod_posterior_refine(self, next, 0, 3, &stop, &status));
    assert_int_equal(who.asks, 3 * 400);
    who = (asker){0, 500};
    assert_false(clod_posterior_refine(self, next, 0, 3, &stop, &status));
    assert_int_equal(status.code, CLOD_INTERRUPTED);
    assert_int_equal(who.asks, 501);
    clod_posterior_destroy(&self);
}

static bool compute(void *context, size_t first, size_t count, const double *at, double *to,
                    clod_status *status)
{
    (void)context;
    (void)status;
    for (size_t row = 2 * first; row < 2 * (first + count); row++) {
        to[row] = 10.0 + 5.0 * sin(2.0 * at[row / 2]);
    }
    return true;
}

static void study_hands_the_stop_to_its_posteriors(void **state)
{
    (void)state;
    plan_made made;
    make_plan(&made, 1);
    for (size_t limit = 0; limit <= 30000;
         limit += 30000) { // in the first posterior, and behind it
        clod_status status = {CLOD_OK, ""};
        asker who = {0, limit};
        const clod_stop stop = {asked, &who};
        const clod_study_source source = {.compute = compute, .stop = &stop};
        clod_study study;
        assert_false(clod_study_run(&made.plan, &source, &study, &status));
        assert_int_equal(status.code, CLOD_INTERRUPTED);
        assert_in_range(who.asks, limit + 1, limit + 1 + AFTER);
        clod_study_fini(&study);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stop_is_heard_wherever_it_comes),
        cmocka_unit_test(stop_is_asked_for_at_every_sample_that_is_looked_at),
        cmocka_unit_test(stop_is_asked_for_at_every_likelihood_and_every_point_left_out),
        cmocka_unit_test(chain_asks_before_every_density),
        cmocka_unit_test(further_points_ask_at_every_candidate),
        cmocka_unit_test(study_hands_the_stop_to_its_posteriors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
