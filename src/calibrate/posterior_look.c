/**
 * @file posterior_look.c
 * What samples of a posterior say: moments and intervals of parameters, predictions of targets, and how well the
 * targets go together.
 */

#include "calibrate/posterior_look.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>

#include "base/memory.h"
#include "base/random.h"
#include "calibrate/chain.h"
#include "calibrate/number.h"
#include "calibrate/posterior_card.h"

#define LOOKED 2000 ///< samples at which the targets are predicted
#define EDGE 0.05
#define MISSED 0.2 ///< share of a population that chains may leave out: its shares are rough
#define ALONG 21   ///< places along the range of a parameter
#define DICE 1000  ///< stream of random numbers beside those of the chains

void clod_posterior_look_ask(const clod_posterior *self, const double *place,
                             const size_t *chosen, clod_surrogate_value *told, double *room)
{
    for (size_t t = 0; t < self->target_count; t++) {
        const clod_posterior_target *of = &self->targets[t];
        if (!of->held_back) {
            told[t] = clod_surrogate_at(of->draws[*chosen++], place, room);
        }
    }
}

/** What the surrogates of targets that are held back, by the draw of this number; NAN where there is none. */
static void ask_held_back(const clod_posterior *self, const double *place, size_t number,
                          clod_surrogate_value *told, double *room)
{
    for (size_t t = 0; t < self->target_count; t++) {
        const clod_posterior_target *of = &self->targets[t];
        if (of->held_back) {
            told[t] = of->surrogate != NULL
                          ? clod_surrogate_at(of->draws[number % self->draws], place, room)
                          : (clod_surrogate_value){(double)NAN, (double)NAN};
        }
    }
}

static void interval(double *values, size_t stride, size_t count, double level, double *low,
                     double *high)
{
    gsl_sort(values, stride, count);
    const double tail = 0.5 * (1.0 - level);
    *low = gsl_stats_quantile_from_sorted_data(values, stride, count, tail);
    *high = gsl_stats_quantile_from_sorted_data(values, stride, count, 1.0 - tail);
}

/** Samples of one parameter. */
static clod_chain_series series_of(const clod_posterior *self, size_t k)
{
    return (clod_chain_series){self->samples + k, CLOD_POSTERIOR_CHAINS,
                               self->count / CLOD_POSTERIOR_CHAINS, self->dimensions};
}

double clod_posterior_look_missed(const clod_posterior *self, const double *places,
                                  size_t count)
{
    const size_t d = self->dimensions;
    double most = 0.0;
    for (size_t k = 0; k < d; k++) {
        double low, high, missed = 0.0;
        gsl_stats_minmax(&low, &high, self->samples + k, d, self->count);
        for (size_t m = 0; m < count; m++) {
            missed += places[m * d + k] < low || places[m * d + k] > high ? 1.0 : 0.0;
        }
        most = fmax(most, missed / (double)count);
    }
    return most;
}

/** Whether chains lie apart, or did not go where their population is. */
static bool look_apart(const clod_posterior *self)
{
    bool apart = self->missed > MISSED;
    for (size_t k = 0; k < self->dimensions; k++) {
        const clod_chain_series series = series_of(self, k);
        apart = apart || !(clod_chain_rhat(&series) <= CLOD_POSTERIOR_APART);
    }
    return apart;
}

/** Moments, interval and agreement of one parameter. `room` [count] */
static void look_at_parameter(const clod_plan *plan, clod_posterior *self, size_t k,
                              double *room)
{
    clod_posterior_parameter *to = &self->parameters[k];
    const double *samples = self->samples + k;
    const size_t d = self->dimensions;
    const clod_chain_series series = series_of(self, k);
    to->rhat = clod_chain_rhat(&series);
    to->effective = clod_chain_effective(&series);
    to->mean = gsl_stats_mean(samples, d, self->count);
    to->deviation = gsl_stats_sd(samples, d, self->count);
    to->below = to->above = 0.0;
    for (size_t i = 0; i < self->count; i++) {
        room[i] = samples[i * d];
        to->below += (room[i] < EDGE ? 1.0 : 0.0) / (double)self->count;
        to->above += (room[i] > 1.0 - EDGE ? 1.0 : 0.0) / (double)self->count;
    }
    interval(room, 1, self->count, plan->sampling.level, &to->low, &to->high);
    to->width = (to->high - to->low) / plan->sampling.level;
    for (size_t m = 0; m < d; m++) {
        self->correlation[k * d + m] =
            k == m ? 1.0 : gsl_stats_correlation(samples, d, self->samples + m, d, self->count);
    }
}

/** Room of clod_posterior_look. */
typedef struct sight {
    const clod_stop *stop;
    size_t looked;              ///< samples
    clod_surrogate_value *told; ///< [looked][targets]
    double *variances;          ///< [looked][targets] of a measured value about what is told
    double *values;             ///< [samples of all chains]
    double *dice;               ///< [groups]
    double *room, *misfit_room;
} sight;

/** What surrogates tell at some samples, errors that are not known drawn; adds up chi-square and p. False
 *  after a stop. */
static bool look_at_samples(const clod_plan *plan, clod_posterior *self, const sight *at)
{
    const size_t groups = clod_misfit_count(self->misfit);
    for (size_t i = 0; i < at->looked; i++) {
        if (clod_stop_asked(at->stop)) {
            return false;
        }
        clod_surrogate_value *told = at->told + i * self->target_count;
        const double *place = clod_posterior_sample(self, i, at->looked);
        clod_posterior_look_ask(self, place,
                                self->chosen + i * self->count / at->looked * self->used, told,
                                at->room);
        ask_held_back(self, place, i, told, at->room);
        for (size_t g = 0; g < groups; g++) {
            at->dice[g] = clod_random_uniform((uint64_t)plan->seed, CLOD_RANDOM_CALIBRATE,
                                              DICE + self->target_count + g, i);
        }
        const double chi =
            clod_misfit_draw(self->misfit, told, at->dice,
                             at->variances + i * self->target_count, at->misfit_room);
        self->chi_square += chi / (double)at->looked;
        self->p_value += gsl_cdf_chisq_Q(chi, (double)self->used) / (double)at->looked;
    }
    return true;
}

/** What is predicted of one target. */
static void predict(const clod_plan *plan, clod_posterior *self, size_t t, const sight *at)
{
    const double looked = (double)at->looked;
    const clod_plan_target *target = &plan->targets[t];
    clod_posterior_target *to = &self->targets[t];
    if (to->surrogate == NULL) {
        to->mean = to->off = to->low = to->high = (double)NAN;
        return;
    }
    double mean = 0.0, square = 0.0, inner = 0.0;
    for (size_t i = 0; i < at->looked; i++) {
        const double told = at->told[i * self->target_count + t].mean;
        const double variance = at->variances[i * self->target_count + t];
        at->values[i] =
            told + sqrt(variance) * clod_random_normal((uint64_t)plan->seed,
                                                       CLOD_RANDOM_CALIBRATE, DICE + t, 2 * i);
        mean += told / looked;
        square += told * told / looked;
        inner += variance / looked;
    }
    to->mean = mean;
    to->off = (target->value - mean) / sqrt(inner + fmax(0.0, square - mean * mean));
    interval(at->values, 1, at->looked, plan->sampling.level, &to->low, &to->high);
}

/** How much a surrogate changes along a parameter, the others at their means: between its least and its greatest mean,
 *  over the deviation of a difference of two numbers with theirs. */
static double change(const clod_posterior *self, size_t t, size_t k, double *room)
{
    double place[CLOD_SURROGATE_MOST];
    clod_surrogate_value least = {HUGE_VAL, 0.0}, greatest = {-HUGE_VAL, 0.0};
    for (size_t m = 0; m < self->dimensions; m++) {
        place[m] = self->parameters[m].mean;
    }
    for (int i = 0; i < ALONG; i++) {
        place[k] = (double)i / (ALONG - 1);
        const clod_surrogate_value told = clod_posterior_told(self, t, place, room);
        least = told.mean < least.mean ? told : least;
        greatest = told.mean > greatest.mean ? told : greatest;
    }
    const double from_to = greatest.mean - least.mean;
    const double deviation = sqrt(least.variance + greatest.variance);
    return from_to > 0.0 ? from_to / deviation : 0.0;
}

/** What moves with a parameter. */
static void look_at_moves(const clod_plan *plan, clod_posterior *self, size_t k, double *room)
{
    self->parameters[k].moved = 0.0;
    for (size_t t = 0; t < self->target_count; t++) {
        if (!plan->targets[t].held_back) {
            self->parameters[k].moved =
                fmax(self->parameters[k].moved, change(self, t, k, room));
        }
    }
}

/** Take back what samples of chains that lie apart cannot tell. */
static void take_back(clod_posterior *self)
{
    const size_t d = self->dimensions;
    for (size_t k = 0; k < d; k++) {
        clod_posterior_parameter *one = &self->parameters[k];
        one->mean = one->deviation = one->low = one->high = (double)NAN;
        one->width = one->moved = self->card[k] = (double)NAN;
        for (size_t m = 0; m < d; m++) {
            self->correlation[k * d + m] = k == m ? 1.0 : (double)NAN;
        }
    }
    for (size_t t = 0; t < self->target_count; t++) {
        clod_posterior_target *one = &self->targets[t];
        one->mean = one->off = one->low = one->high = (double)NAN;
        one->at_card = one->unsure = (double)NAN;
    }
}

/** No strength, density or mass is below 0, as surrogates may be; sigma_2 of a solid that does not flow is. */
static void cut_amounts(const clod_plan *plan, clod_posterior *self)
{
    for (size_t t = 0; t < self->target_count; t++) {
        clod_posterior_target *one = &self->targets[t];
        if (one->surrogate != NULL && clod_number_is_amount(plan, &plan->targets[t])) {
            one->mean = fmax(one->mean, 0.0);
            one->low = fmax(one->low, 0.0);
            one->high = fmax(one->high, 0.0);
            one->at_card = fmax(one->at_card, 0.0);
        }
    }
}

/** Parameters, targets, and how well the targets go together. */
static bool look_at_all(const clod_plan *plan, clod_posterior *self, const sight *at,
                        clod_status *status)
{
    for (size_t k = 0; k < self->dimensions; k++) {
        look_at_parameter(plan, self, k, at->values);
    }
    for (size_t k = 0; k < self->dimensions; k++) {
        look_at_moves(plan, self, k, at->room);
    }
    for (size_t t = 0; t < self->target_count; t++) {
        const bool used = !plan->targets[t].held_back;
        self->predictive =
            self->predictive || (used && self->targets[t].checked &&
                                 self->targets[t].check.q2 >= CLOD_POSTERIOR_LEAST_Q2);
    }
    if (!look_at_samples(plan, self, at)) {
        return clod_stop_fail(status);
    }
    for (size_t t = 0; t < self->target_count; t++) {
        predict(plan, self, t, at);
    }
    self->apart = look_apart(self);
    if (self->apart) {
        take_back(self);
        return true;
    }
    const clod_posterior_sight card = {at->looked, at->told, at->room};
    if (!clod_posterior_card_choose(plan, &card, self, status)) {
        return false;
    }
    cut_amounts(plan, self);
    return true;
}

bool clod_posterior_look(const clod_posterior_runs *runs, clod_posterior *self,
                         clod_status *status)
{
    const size_t looked = self->count < LOOKED ? self->count : LOOKED;
    const size_t numbers = looked * self->target_count;
    const sight at = {
        .stop = runs->stop,
        .looked = looked,
        .told = clod_memory_alloc(numbers, sizeof *at.told),
        .variances = clod_memory_alloc(numbers, sizeof(double)),
        .values = clod_memory_alloc(self->count, sizeof(double)),
        .dice = clod_memory_alloc(clod_misfit_count(self->misfit), sizeof(double)),
        .room = clod_posterior_room(self),
        .misfit_room = clod_memory_alloc(clod_misfit_room(self->misfit), sizeof(double))};
    const bool good =
        at.told != NULL && at.variances != NULL && at.values != NULL && at.dice != NULL &&
                at.room != NULL && at.misfit_room != NULL
            ? look_at_all(runs->plan, self, &at, status)
            : clod_status_fail(status, CLOD_FAILED, "No memory for the posterior.");
    clod_memory_free(at.told);
    clod_memory_free(at.variances);
    clod_memory_free(at.values);
    clod_memory_free(at.dice);
    clod_memory_free(at.room);
    clod_memory_free(at.misfit_room);
    return good;
}
