#include "calibrate/posterior_card.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"

#define MEETS 0.9 ///< quantile of the samples' misfits that the means may have
#define BEST 0.1  ///< share of the samples that a card may be of
#define BINS 20   ///< of the range
#define GAP 0.1   ///< of the samples on either side
#define GROUP 0.05

/** Sum over the used targets of the square of what is missed over its variance. Errors that are not known count as they
 *  are estimated: those drawn with a sample are the larger, the more it misses. */
static double misfit(const clod_plan *plan, const clod_surrogate_value *told)
{
    double sum = 0.0;
    for (size_t t = 0; t < plan->target_count; t++) {
        const clod_plan_target *target = &plan->targets[t];
        const double away = target->value - told[t].mean;
        sum += target->held_back
                   ? 0.0
                   : away * away / (clod_posterior_variance(target) + told[t].variance);
    }
    return sum;
}

/** What all surrogates tell at a place. */
static double look(const clod_plan *plan, const clod_posterior *self, const double *place,
                   const clod_posterior_sight *at, clod_surrogate_value *told)
{
    for (size_t t = 0; t < plan->target_count; t++) {
        told[t] = self->targets[t].surrogate != NULL
                      ? clod_posterior_told(self, t, place, at->room)
                      : (clod_surrogate_value){(double)NAN, (double)NAN};
    }
    return misfit(plan, told);
}

/** Square of the distance from the means, in deviations. */
static double distance(const clod_posterior *self, const double *place)
{
    double sum = 0.0;
    for (size_t k = 0; k < self->dimensions; k++) {
        const clod_posterior_parameter *one = &self->parameters[k];
        const double away = place[k] - one->mean;
        sum += one->deviation > 0.0 ? away * away / (one->deviation * one->deviation) : 0.0;
    }
    return sum;
}

/** Of the samples that miss the targets no more than `most` the one nearest to the means. */
static const double *nearest(const clod_posterior *self, const double *misfits, size_t looked,
                             double most)
{
    const double *found = clod_posterior_sample(self, 0, looked);
    double least = HUGE_VAL;
    for (size_t i = 0; i < looked; i++) {
        const double *place = clod_posterior_sample(self, i, looked);
        const double away = distance(self, place);
        if (misfits[i] <= most && away < least) {
            least = away;
            found = place;
        }
    }
    return found;
}

bool clod_posterior_card_choose(const clod_plan *plan, const clod_posterior_sight *at,
                                clod_posterior *self, clod_status *status)
{
    const size_t targets = plan->target_count;
    double *misfits = clod_memory_alloc(2 * at->looked, sizeof *misfits);
    clod_surrogate_value *told = clod_memory_alloc(targets, sizeof *told);
    const bool good = misfits != NULL && told != NULL;
    if (good) {
        double *sorted = misfits + at->looked;
        for (size_t i = 0; i < at->looked; i++) {
            misfits[i] = misfit(plan, at->told + i * targets);
        }
        memcpy(sorted, misfits, at->looked * sizeof *sorted);
        gsl_sort(sorted, 1, at->looked);
        for (size_t k = 0; k < self->dimensions; k++) {
            self->card[k] = self->parameters[k].mean;
        }
        const double most = gsl_stats_quantile_from_sorted_data(sorted, 1, at->looked, MEETS);
        self->card_is_mean = look(plan, self, self->card, at, told) <= most;
        if (!self->card_is_mean) {
            const double best =
                gsl_stats_quantile_from_sorted_data(sorted, 1, at->looked, BEST);
            memcpy(self->card, nearest(self, misfits, at->looked, best),
                   self->dimensions * sizeof *self->card);
            (void)look(plan, self, self->card, at, told);
        }
        for (size_t t = 0; t < targets; t++) {
            self->targets[t].at_card = told[t].mean;
            self->targets[t].unsure = sqrt(told[t].variance);
        }
    }
    clod_memory_free(misfits);
    clod_memory_free(told);
    return good || clod_status_fail(status, CLOD_FAILED, "No memory for the card.");
}

/** Samples in each part of the range. */
static void count(const clod_posterior *self, size_t k, double bins[BINS])
{
    for (size_t i = 0; i < self->count; i++) {
        const double place = self->samples[i * self->dimensions + k];
        bins[(size_t)fmin(place * BINS, BINS - 1)] += 1.0;
    }
}

static double most_of(const double *bins, size_t from, size_t to)
{
    double most = 0.0;
    for (size_t b = from; b < to; b++) {
        most = fmax(most, bins[b]);
    }
    return most;
}

/** Shares and means of the samples on either side of a place. */
static void part(const clod_posterior *self, size_t k, double at, clod_posterior_split *found)
{
    double low = 0.0, all = (double)self->count;
    *found = (clod_posterior_split){0};
    for (size_t i = 0; i < self->count; i++) {
        const double place = self->samples[i * self->dimensions + k];
        low += place < at ? 1.0 : 0.0;
        *(place < at ? &found->below : &found->above) += place;
    }
    found->share = low / all;
    found->below /= fmax(low, 1.0);
    found->above /= fmax(all - low, 1.0);
}

bool clod_posterior_is_split(const clod_posterior *self, size_t k, clod_posterior_split *found)
{
    double bins[BINS] = {0.0};
    count(self, k, bins);
    for (size_t b = 1; b + 1 < BINS; b++) {
        const double sides = fmin(most_of(bins, 0, b), most_of(bins, b + 1, BINS));
        if (bins[b] < GAP * sides) {
            part(self, k, ((double)b + 0.5) / BINS, found);
            if (found->share >= GROUP && found->share <= 1.0 - GROUP) {
                return true;
            }
        }
    }
    return false;
}
