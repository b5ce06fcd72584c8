#include "calibrate/study.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/plural.h"
#include "calibrate/estimate.h"
#include "calibrate/sobol.h"

#define BATCHES 3

/** Room for as many points. */
static bool grow(const clod_plan *plan, clod_study *self, size_t points, clod_status *status)
{
    const size_t each = (size_t)plan->seeds * plan->target_count;
    double *places = clod_memory_grow(self->places, self->points * plan->parameter_count,
                                      points * plan->parameter_count, sizeof *places);
    if (places != NULL) {
        self->places = places;
    }
    double *results =
        clod_memory_grow(self->results, self->points * each, points * each, sizeof *results);
    for (size_t k = self->points * each; results != NULL && k < points * each; k++) {
        results[k] = (double)NAN; // a run that is never done has no result
    }
    if (results != NULL) {
        self->results = results;
    }
    return (places != NULL && results != NULL) ||
           clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", points);
}

/** Compute up to `points`, whose places are there. */
static bool compute(const clod_study_source *source, clod_study *self, size_t points,
                    clod_status *status)
{
    const size_t first = self->points;
    self->points = points;
    return source->compute(source->context, first, points - first, self->places, self->results,
                           status);
}

static void tell(const clod_study_source *source, const char *text)
{
    if (source->tell != NULL) {
        source->tell(source->context, text);
    }
}

/** A budget that is enough for so much, and stays so in words: with 5 % more, and from minutes on whole ones. */
static double next_budget(double seconds)
{
    const double more = 1.05 * seconds;
    return more < 600.0 ? more : 60.0 * ceil(more / 60.0);
}

/** How many points there will be, when the first is computed. */
static bool count_points(const clod_plan *plan, const clod_study_source *source, size_t *points,
                         clod_status *status)
{
    if (plan->points > 0) {
        *points = (size_t)plan->points;
        return true;
    }
    const double each = source->seconds(source->context, 1);
    const size_t least = clod_plan_least_points(plan->parameter_count);
    const double fit = clod_estimate_points(plan, each);
    *points = (size_t)fit;
    char text[240], words[CLOD_ESTIMATE_WORDS], more[CLOD_ESTIMATE_WORDS];
    const char *budget = clod_estimate_clock(plan->budget, words);
    if (fit < CLOD_PLAN_BUDGET_POINTS) {
        snprintf(text, sizeof text, "the first point took %.3g s: %.0f point%s fit into %s",
                 each, fit, clod_plural(fit), budget);
    } else {
        snprintf(text, sizeof text,
                 "the first point took %.3g s: %d points, the most that a budget buys, take %s "
                 "of its %s",
                 each, CLOD_PLAN_BUDGET_POINTS,
                 clod_estimate_clock(CLOD_PLAN_BUDGET_POINTS * each, more), budget);
    }
    tell(source, text);
    if (*points < least) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s: the budget of %s is too small: the first point, %lld packing%s of each test, took "
            "%.3g s, so %.0f point%s fit, and %zu parameter%s need%s at least %zu: %s. Give a "
            "larger budget and the same command goes on; smaller cells, softer contacts or fewer seeds "
            "make runs shorter.",
            plan->path, budget, (long long)plan->seeds, clod_plural((double)plan->seeds), each,
            fit, clod_plural(fit), plan->parameter_count,
            clod_plural((double)plan->parameter_count), plan->parameter_count == 1 ? "s" : "",
            least, clod_estimate_clock(next_budget(each * (double)least), more));
    }
    return true;
}

/** Whether another batch fits the budget, by what the points so far have taken. */
static bool fits(const clod_plan *plan, const clod_study_source *source, size_t done,
                 size_t more)
{
    return plan->points > 0 ||
           source->seconds(source->context, done) * (double)(done + more) <= plan->budget;
}

static bool renew_posterior(const clod_plan *plan, const clod_study_source *source,
                            clod_study *self, clod_status *status)
{
    const clod_posterior_runs runs = {plan, self->points, self->places, self->results,
                                      source->stop};
    clod_posterior_destroy(&self->posterior);
    self->posterior = clod_posterior_create(&runs, status);
    return self->posterior != NULL;
}

/** Further points that stand for the posterior. */
static bool refine(const clod_plan *plan, const clod_study_source *source, size_t points,
                   clod_study *self, clod_status *status)
{
    const size_t batch = (points - self->points + BATCHES - 1) / BATCHES;
    while (self->points < points) {
        const size_t left = points - self->points;
        const size_t more = batch < left ? batch : left;
        if (!fits(plan, source, self->points, more)) {
            tell(source, "the budget is spent: no further points");
            return true;
        }
        if (!grow(plan, self, self->points + more, status) ||
            !clod_posterior_refine(self->posterior, self->places, self->points, more,
                                   source->stop, status) ||
            !compute(source, self, self->points + more, status) ||
            !renew_posterior(plan, source, self, status)) {
            return false;
        }
    }
    return true;
}

bool clod_study_run(const clod_plan *plan, const clod_study_source *source, clod_study *study,
                    clod_status *status)
{
    *study = (clod_study){0};
    size_t points;
    if (!grow(plan, study, 1, status)) {
        return false;
    }
    for (size_t k = 0; k < plan->parameter_count; k++) {
        study->places[k] = 0.5; // the first of a Sobol sequence
    }
    if (!compute(source, study, 1, status)) {
        return false;
    }
    if (source->look != NULL) {
        source->look(source->context);
    }
    if (!count_points(plan, source, &points, status)) {
        return false;
    }
    study->designed = clod_plan_design_points(plan->parameter_count, points);
    if (!grow(plan, study, study->designed, status)) {
        return false;
    }
    if (!clod_sobol_fill(plan->parameter_count, study->designed, study->places)) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the design.");
    }
    return compute(source, study, study->designed, status) &&
           renew_posterior(plan, source, study, status) &&
           refine(plan, source, points, study, status);
}

void clod_study_fini(clod_study *self)
{
    clod_memory_free(self->places);
    clod_memory_free(self->results);
    clod_posterior_destroy(&self->posterior);
    *self = (clod_study){0};
}
