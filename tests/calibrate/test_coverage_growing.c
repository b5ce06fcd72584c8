/**
 * A synthetic material whose packings scatter four times as much at one end of the range as at the other. 90 %
 * intervals must hold the truth where packings scatter little and where they scatter much. Asserted is for each
 * that, were the share 0.9, so few or fewer would hold it in more than one of 1000 such tests.
 */

#include <gsl/gsl_cdf.h>

#include "base/random.h"
#include "calibrate/study.h"
#include "plan_made.h"
#include "support/check.h"

#define PACKINGS 3
#define NOISE 0.5  ///< standard deviation between packings at the lower end, deg
#define FACTOR 4.0 ///< so many times as large at the upper end
#define ERROR 0.25 ///< of the laboratory, deg: small, so that the scatter of packings counts

#define REPEATS 40 ///< docs/theory/calibration.md has them with 400

/** What came out, of truths near the lower and near the upper end of the range. */
typedef struct counts {
    int repeats[2], inside[2];
    double width[2]; ///< mean, of the range
} counts;

/** An angle. */
static double formula(double u)
{
    return 30.0 + 30.0 * u;
}

static bool compute(void *context, size_t first, size_t count, const double *places,
                    double *results, clod_status *status)
{
    (void)status;
    const uint64_t *repeat = context;
    for (size_t run = PACKINGS * first; run < PACKINGS * (first + count); run++) {
        const double u = places[run / PACKINGS];
        results[run] =
            formula(u) + NOISE * pow(FACTOR, u) *
                             clod_random_normal(*repeat, CLOD_RANDOM_TEST, 100 + run, 0);
    }
    return true;
}

static void repeat(int64_t points, uint64_t number, counts *to)
{
    const int end = (int)(number % 2); // one and the other in turn
    const double truth =
        0.05 + 0.7 * end + 0.2 * clod_random_uniform(number, CLOD_RANDOM_TEST, 90, 0);
    plan_made plan;
    plan_make(&plan, 1, 1);
    plan.plan.seed = (int64_t)number;
    plan.plan.seeds = PACKINGS;
    plan.plan.points = points;
    plan.plan.sampling.samples = 500;
    plan.targets[0].value =
        formula(truth) + ERROR * clod_random_normal(number, CLOD_RANDOM_TEST, 80, 0);
    plan.targets[0].error = ERROR;
    const clod_study_source source = {.compute = compute, .context = &number};
    clod_study study;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_study_run(&plan.plan, &source, &study, &status));
    const clod_posterior_parameter *found = &study.posterior->parameters[0];
    to->inside[end] += truth >= found->low && truth <= found->high ? 1 : 0;
    to->width[end] += found->width;
    to->repeats[end]++;
    clod_study_fini(&study);
}

static void hold(int64_t points)
{
    static const char *const ENDS[] = {"little", "much"};
    counts all = {{0}, {0}, {0.0}};
    for (int k = 1; k <= REPEATS; k++) {
        repeat(points, (uint64_t)k, &all);
    }
    for (int end = 0; end < 2; end++) {
        print_message("%lld points, packings scatter %s: %d of %d intervals hold the truth; "
                      "mean width %.3f of the range\n",
                      (long long)points, ENDS[end], all.inside[end], all.repeats[end],
                      all.width[end] / all.repeats[end]);
    }
    for (int end = 0; end < 2; end++) {
        assert_true(gsl_cdf_binomial_P((unsigned)all.inside[end], 0.9,
                                       (unsigned)all.repeats[end]) > 1e-3);
    }
}

static void few_points(void **state)
{
    (void)state;
    hold(8);
}

static void many_points(void **state)
{
    (void)state;
    hold(16);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(few_points),
        cmocka_unit_test(many_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
