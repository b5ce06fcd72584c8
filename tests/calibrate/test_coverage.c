/**
 * A synthetic material: a formula with the noise of packings in place of simulations, and a laboratory that
 * measures its truth with errors. Calibrated as simulations are, the truth must lie in the 90 % intervals
 * as often as they say: in 8 of the first 10 repeats, and of 20 repeats so often that 0.9 is not refuted.
 */

#include <gsl/gsl_cdf.h>

#include "coverage_study.h"

#define REPEATS 20
#define PARAMETERS 2
#define TARGETS 3

static const double NOISE[TARGETS] = {1.5, 0.8, 12.0};
static const double ERROR[TARGETS] = {1.0, 0.5, 8.0};

/** An angle, a cohesion, a density: curved in both parameters. */
static void formula(const double *u, double *result)
{
    result[0] = 22.0 + 14.0 * sqrt(0.05 + u[0]) + 3.0 * sin(3.0 * u[1]);
    result[1] = 2.0 + 6.0 * u[0] * u[0] + 5.0 * u[1];
    result[2] = 1300.0 - 120.0 * u[0] - 60.0 * exp(-2.0 * u[1]);
}

static void the_truth_lies_in_its_intervals_as_often_as_they_say(void **state)
{
    (void)state;
    const coverage_study_material ore = {PARAMETERS, TARGETS, NOISE, ERROR, formula, 1000, 0};
    double width = 0.0;
    int all = 0, first = 0;
    for (uint64_t k = 0; k < REPEATS; k++) {
        const int inside = coverage_study_repeat(&ore, k + 1, &width);
        all += inside;
        first += k < 10 && inside == PARAMETERS ? 1 : 0;
    }
    width /= REPEATS * PARAMETERS;
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
