#pragma once
/**
 * @file coverage.h
 * How often 90 % intervals hold the truth when targets of one test have errors in common and the laboratory
 * has few specimens: a formula in place of simulations, with packings and specimens whose numbers move together.
 */

#include <gsl/gsl_cdf.h>
#include <math.h>

#include "base/random.h"
#include "calibrate/plan_samples.h"
#include "calibrate/study.h"
#include "plan_made.h"
#include "support/check.h"

#define COVERAGE_TARGETS 3
#define COVERAGE_PACKINGS 3
#define COVERAGE_SPECIMENS 24 ///< at most: with so many, errors are known
#define COVERAGE_NOISE 0.05   ///< between packings and between specimens of one point
#define COVERAGE_SLOPE 0.35

/** One scheme. */
typedef struct coverage {
    double correlation; ///< between the targets
    int specimens;
    int64_t points;
    int repeats;
} coverage;

typedef struct coverage_solid {
    const coverage *of;
    uint64_t repeat;
} coverage_solid;

/** Numbers 0, 1, 2 with a correlation between them: a part that they share and one of each. */
static inline double coverage_noise(const coverage_solid *self, uint64_t item, uint64_t target)
{
    const double shared =
        clod_random_normal(self->repeat, CLOD_RANDOM_TEST, 1000 * (item + 1), 0);
    const double own =
        clod_random_normal(self->repeat, CLOD_RANDOM_TEST, 1000 * (item + 1) + 1 + target, 0);
    return COVERAGE_NOISE *
           (sqrt(self->of->correlation) * shared + sqrt(1.0 - self->of->correlation) * own);
}

/** Shear stresses of three points of a yield locus. */
static inline double coverage_formula(double u, uint64_t target)
{
    return 0.33 + 0.08 * (double)target + COVERAGE_SLOPE * u;
}

static inline bool coverage_compute(void *context, size_t first, size_t count,
                                    const double *places, double *results, clod_status *status)
{
    (void)status;
    const coverage_solid *self = context;
    for (size_t run = COVERAGE_PACKINGS * first; run < COVERAGE_PACKINGS * (first + count);
         run++) {
        for (uint64_t t = 0; t < COVERAGE_TARGETS; t++) {
            results[run * COVERAGE_TARGETS + t] =
                coverage_formula(places[run / COVERAGE_PACKINGS], t) +
                coverage_noise(self, 100 + run, t);
        }
    }
    return true;
}

/** Targets as a table with specimens makes them. */
static inline void coverage_measure(const coverage_solid *self, double truth, plan_made *plan)
{
    clod_plan_sample items[COVERAGE_TARGETS * COVERAGE_SPECIMENS];
    double scratch[COVERAGE_TARGETS * COVERAGE_SPECIMENS];
    clod_plan_samples list = {.items = items, .scratch = scratch};
    for (uint64_t t = 0; t < COVERAGE_TARGETS; t++) {
        for (int s = 0; s < self->of->specimens; s++) {
            items[list.count++] = (clod_plan_sample){
                .stress = 500.0 * (double)(t + 1),
                .value = coverage_formula(truth, t) + coverage_noise(self, (uint64_t)s, t),
                .error = 1e-6, // of the instrument
                .specimen = s};
        }
    }
    clod_plan_samples_merge(&list, 0.0);
    assert_int_equal(list.count, COVERAGE_TARGETS);
    for (size_t t = 0; t < COVERAGE_TARGETS; t++) {
        plan->targets[t].value = items[t].value;
        plan->targets[t].error = items[t].error;
        plan->targets[t].repeats = items[t].repeats;
        plan->targets[t].table = 1;
    }
}

/** Whether the truth lies in its interval. */
static inline bool coverage_repeat(const coverage *self, uint64_t number, double *width)
{
    coverage_solid solid = {self, number};
    const double truth = 0.15 + 0.7 * clod_random_uniform(number, CLOD_RANDOM_TEST, 90, 0);
    plan_made plan;
    plan_make(&plan, 1, COVERAGE_TARGETS);
    plan.plan.seed = (int64_t)number;
    plan.plan.seeds = COVERAGE_PACKINGS;
    plan.plan.points = self->points;
    plan.plan.sampling.samples = 500;
    coverage_measure(&solid, truth, &plan);
    const clod_study_source source = {.compute = coverage_compute, .context = &solid};
    clod_study study;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_study_run(&plan.plan, &source, &study, &status));
    const clod_posterior_parameter *found = &study.posterior->parameters[0];
    const bool inside = truth >= found->low && truth <= found->high;
    *width += found->width / self->repeats;
    clod_study_fini(&study);
    return inside;
}

/** Whether at a true share of 0.9 so few or fewer hold it in more than one of 1000 such tests, and the intervals are
 *  no wider than `most`. */
static inline bool coverage_holds(const coverage *self, double most)
{
    int inside = 0;
    double width = 0.0;
    for (int k = 1; k <= self->repeats; k++) {
        inside += coverage_repeat(self, (uint64_t)k, &width) ? 1 : 0;
    }
    print_message("correlation %.1f, %d specimens, %lld points: %d of %d intervals hold the "
                  "truth; mean width %.2f of the range\n",
                  self->correlation, self->specimens, (long long)self->points, inside,
                  self->repeats, width);
    return width <= most &&
           gsl_cdf_binomial_P((unsigned)inside, 0.9, (unsigned)self->repeats) > 1e-3;
}
