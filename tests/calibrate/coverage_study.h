#pragma once
/**
 * @file coverage_study.h
 * A synthetic material: a formula with the noise of packings in place of simulations, and a laboratory that
 * measures its truth with errors, calibrated as simulations are.
 */

#include "base/random.h"
#include "calibrate/study.h"
#include "plan_made.h"
#include "support/check.h"

#define COVERAGE_STUDY_MOST 5 ///< parameters, targets
#define COVERAGE_STUDY_PACKINGS 2

typedef struct coverage_study_material {
    size_t parameters, targets;
    const double *noise; ///< [targets] standard deviation between packings
    const double *error; ///< [targets] of the laboratory
    void (*formula)(const double *u, double *result);
    int64_t samples; ///< of each chain
    uint64_t repeat;
} coverage_study_material;

static inline double coverage_study_normal(uint64_t repeat, uint64_t item)
{
    return clod_random_normal(repeat, CLOD_RANDOM_TEST, item, 0);
}

static inline bool coverage_study_compute(void *context, size_t first, size_t count,
                                          const double *places, double *results,
                                          clod_status *status)
{
    (void)status;
    const coverage_study_material *self = context;
    const size_t packings = COVERAGE_STUDY_PACKINGS, targets = self->targets;
    for (size_t row = packings * first; row < packings * (first + count); row++) {
        self->formula(places + row / packings * self->parameters, results + row * targets);
        for (size_t t = 0; t < targets; t++) {
            results[row * targets + t] +=
                self->noise[t] * coverage_study_normal(self->repeat, 100 + row * targets + t);
        }
    }
    return true;
}

/** How many of the true parameters lie in their intervals; adds the widths of these to *width. */
static inline int coverage_study_repeat(const coverage_study_material *of, uint64_t number,
                                        double *width)
{
    coverage_study_material made = *of;
    made.repeat = number;
    double truth[COVERAGE_STUDY_MOST];
    for (uint64_t k = 0; k < made.parameters; k++) {
        truth[k] = 0.15 + 0.7 * clod_random_uniform(number, CLOD_RANDOM_TEST, 90 + k, 0);
    }
    plan_made plan;
    plan_make(&plan, made.parameters, made.targets);
    plan.plan.seed = (int64_t)number;
    plan.plan.sampling.samples = made.samples;
    double result[COVERAGE_STUDY_MOST];
    made.formula(truth, result);
    for (size_t t = 0; t < made.targets; t++) {
        plan.targets[t].value =
            result[t] + made.error[t] * coverage_study_normal(number, 80 + t);
        plan.targets[t].error = made.error[t];
    }
    const clod_study_source source = {.compute = coverage_study_compute, .context = &made};
    clod_study study;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_study_run(&plan.plan, &source, &study, &status));
    assert_int_equal(study.points, 24);
    assert_int_equal(study.designed, 16);
    int inside = 0;
    for (size_t k = 0; k < made.parameters; k++) {
        const clod_posterior_parameter *found = &study.posterior->parameters[k];
        inside += truth[k] >= found->low && truth[k] <= found->high ? 1 : 0;
        *width += found->width;
        check_at_most(found->rhat, 1.05);
    }
    clod_study_fini(&study);
    return inside;
}
