/**
 * A synthetic material: a formula with the noise of packings in place of simulations, and a laboratory that
 * measures its truth with errors. Calibrated as simulations are, the truth must lie in the 90 % intervals
 * as often as they say: in 8 of the first 10 repeats, and of 20 repeats so often that 0.9 is not refuted.
 */

#include <gsl/gsl_cdf.h>

#include "base/random.h"
#include "calibrate/study.h"
#include "plan_made.h"
#include "support/check.h"

#define REPEATS 20
#define PARAMETERS 2
#define TARGETS 3

static const double NOISE[TARGETS] = {1.5, 0.8, 12.0}; ///< standard deviation between packings
static const double ERROR[TARGETS] = {1.0, 0.5, 8.0};  ///< of the laboratory

static double normal(uint64_t repeat, uint64_t item)
{
    return clod_random_normal(repeat, CLOD_RANDOM_TEST, item, 0);
}

/** An angle, a cohesion, a density: curved in both parameters. */
static void formula(const double *u, double result[TARGETS])
{
    result[0] = 22.0 + 14.0 * sqrt(0.05 + u[0]) + 3.0 * sin(3.0 * u[1]);
    result[1] = 2.0 + 6.0 * u[0] * u[0] + 5.0 * u[1];
    result[2] = 1300.0 - 120.0 * u[0] - 60.0 * exp(-2.0 * u[1]);
}

typedef struct material {
    uint64_t repeat;
    double truth[PARAMETERS];
} material;

static bool compute(void *context, size_t first, size_t count, const double *places,
                    double *results, clod_status *status)
{
    (void)status;
    const material *self = context;
    for (size_t row = 2 * first; row < 2 * (first + count); row++) {
        formula(places + row / 2 * PARAMETERS, results + row * TARGETS);
        for (size_t t = 0; t < TARGETS; t++) {
            results[row * TARGETS + t] +=
                NOISE[t] * normal(self->repeat, 100 + row * TARGETS + t);
        }
    }
    return true;
}

/** How many of the true parameters lie in their intervals. */
static int repeat(uint64_t number, double *width)
{
    material made = {.repeat = number};
    for (uint64_t k = 0; k < PARAMETERS; k++) {
        made.truth[k] = 0.15 + 0.7 * clod_random_uniform(number, CLOD_RANDOM_TEST, 90 + k, 0);
    }
    plan_made plan;
    plan_make(&plan, PARAMETERS, TARGETS);
    plan.plan.seed = (int64_t)number;
    plan.plan.sampling.samples = 1000;
    double result[TARGETS];
    formula(made.truth, result);
    for (size_t t = 0; t < TARGETS; t++) {
        plan.targets[t].value = result[t] + ERROR[t] * normal(number, 80 + t);
        plan.targets[t].error = ERROR[t];
    }
    const clod_study_source source = {.compute = compute, .context = &made};
    clod_study study;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_study_run(&plan.plan, &source, &study, &status));
    assert_int_equal(study.points, 24);
    assert_int_equal(study.designed, 16);
    int inside = 0;
    for (size_t k = 0; k < PARAMETERS; k++) {
        const clod_posterior_parameter *found = &study.posterior->parameters[k];
        inside += made.truth[k] >= found->low && made.truth[k] <= found->high ? 1 : 0;
        *width += found->width / (REPEATS * PARAMETERS);
        check_at_most(found->rhat, 1.05);
    }
    clod_study_fini(&study);
    return inside;
}

static void the_truth_lies_in_its_intervals_as_often_as_they_say(void **state)
{
    (void)state;
    double width = 0.0;
    int all = 0, first = 0;
    for (uint64_t k = 0; k < REPEATS; k++) {
        const int inside = repeat(k + 1, &width);
        all += inside;
        first += k < 10 && inside == PARAMETERS ? 1 : 0;
    }
    print_message(
        "both parameters inside in %d of 10 repeats; %d of %d intervals hold the truth; mean "
        "width %.2f of the range\n",
        first, all, REPEATS * PARAMETERS, width);
    assert_true(first >= 8);
    // At a true share of 0.9: this few or fewer in one of 1000 such tests.
    assert_true(gsl_cdf_binomial_P((unsigned)all, 0.9, REPEATS * PARAMETERS) > 1e-3);
    // Intervals that hold the truth by being wide tell nothing.
    check_at_most(width, 0.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_truth_lies_in_its_intervals_as_often_as_they_say),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
