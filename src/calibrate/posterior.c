#include "calibrate/posterior.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/random.h"
#include "calibrate/chain.h"

#define CHAINS 4
#define WARM_UP 2000
#define LOOKED 2000 ///< samples at which the targets are predicted
#define EDGE 0.05
#define DICE 1000          ///< stream of random numbers beside those of the chains
#define DRAWN 1000000      ///< and the first one of what surrogates of used targets do not know
#define DRAWN_BACK 2000000 ///< and of those held back

#define MANY 256 ///< points: with more there are fewer draws, for each is a matrix of them

_Static_assert(CLOD_PLAN_PARAMETERS <= CLOD_CHAIN_MOST, "chains take all parameters of a plan");
_Static_assert(CLOD_PLAN_PARAMETERS <= CLOD_SURROGATE_MOST,
               "surrogates take all parameters of a plan");

/** What the density needs. */
typedef struct density {
    const clod_posterior *of;
    clod_surrogate_value *told; ///< [targets]
    double *room, *misfit_room; ///< of the surrogates, of the misfit
} density;

double clod_posterior_variance(const clod_plan_target *target)
{
    return target->error * target->error + target->discrepancy * target->discrepancy;
}

/** What the surrogates of the used targets say at a place, each by one of its draws. */
static void ask(const clod_posterior *self, const double *place, const size_t *chosen,
                clod_surrogate_value *told, double *room)
{
    for (size_t t = 0; t < self->target_count; t++) {
        const clod_posterior_target *of = &self->targets[t];
        if (!of->held_back) {
            told[t] = clod_surrogate_at(of->draws[*chosen++], place, room);
        }
    }
}

/** And those of the targets that are held back, by the draw of this number; NAN where there is none. */
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

static double log_density(void *context, const double *place, const size_t *chosen)
{
    const density *self = context;
    ask(self->of, place, chosen, self->told, self->room);
    return clod_misfit_density(self->of->misfit, self->told, self->misfit_room);
}

/** The runs that have a target's number. */
static size_t take(const clod_posterior_runs *runs, size_t target, double *inputs,
                   double *results)
{
    const clod_plan *plan = runs->plan;
    const size_t d = plan->parameter_count;
    const size_t seeds = (size_t)plan->seeds;
    size_t count = 0;
    for (size_t row = 0; row < runs->points * seeds; row++) {
        const double value = runs->results[row * plan->target_count + target];
        if (isfinite(value)) {
            memcpy(inputs + count * d, runs->places + row / seeds * d, d * sizeof *inputs);
            results[count++] = value;
        }
    }
    return count;
}

/** Draws of what a surrogate of so many points does not know: they take the room of those of MANY points, or 4 draws. */
static size_t draws_for(size_t points)
{
    const double most = (double)CLOD_POSTERIOR_DRAWS;
    const double share = (double)MANY / (double)(points > 0 ? points : 1);
    return (size_t)fmax(4.0, fmin(most, most * share * share));
}

static bool fit_target(const clod_posterior_runs *runs, size_t number, double *room,
                       clod_posterior *self, clod_status *status)
{
    const clod_plan *plan = runs->plan;
    const size_t d = plan->parameter_count;
    const size_t all = runs->points * (size_t)plan->seeds;
    clod_posterior_target *to = &self->targets[number];
    const size_t count = take(runs, number, room, room + all * d);
    const clod_surrogate_runs taken = {d, count, room, room + all * d, runs->stop};
    const clod_surrogate_kind kind = clod_surrogate_choose(d, clod_surrogate_points(&taken));
    clod_status why = {CLOD_OK, ""};
    to->runs = count;
    to->surrogate = clod_surrogate_create(&taken, kind, &why);
    if (why.code == CLOD_INTERRUPTED) {
        return clod_stop_fail(status);
    }
    if (to->surrogate == NULL && plan->targets[number].held_back) { // nothing depends on it
        snprintf(to->why, sizeof to->why, "%s", why.text);
        return true;
    }
    if (to->surrogate == NULL) {
        return clod_status_fail(
            status, CLOD_FAILED,
            "Target %s: %zu of %zu runs have this number. %s Other ranges, or "
            "another target, may help; runs.csv has all results.",
            plan->targets[number].name, count, all, why.text);
    }
    to->checked = clod_surrogate_leave_one_out(to->surrogate, runs->stop, &to->check, &why);
    if (why.code == CLOD_INTERRUPTED) {
        return clod_stop_fail(status);
    }
    // those of a used target do not depend on those held back, so that one may be added to runs that are done
    size_t among = 0;
    for (size_t t = 0; t < number; t++) {
        among += plan->targets[t].held_back == plan->targets[number].held_back ? 1 : 0;
    }
    const clod_surrogate_dice dice = {(uint64_t)plan->seed,
                                      (plan->targets[number].held_back ? DRAWN_BACK : DRAWN) +
                                          2 * among};
    return clod_surrogate_draw(to->surrogate, &dice, self->draws, runs->stop, to->draws,
                               &to->independent, status);
}

static bool fit(const clod_posterior_runs *runs, clod_posterior *self, clod_status *status)
{
    const size_t all = runs->points * (size_t)runs->plan->seeds;
    double *room = clod_memory_alloc(all * (self->dimensions + 1), sizeof *room);
    if (room == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the runs.");
    }
    bool good = true;
    self->draws = draws_for(runs->points);
    for (size_t t = 0; t < self->target_count && good; t++) {
        good = fit_target(runs, t, room, self, status);
    }
    clod_memory_free(room);
    return good;
}

double *clod_posterior_room(const clod_posterior *self, size_t more)
{
    size_t most = 1;
    for (size_t t = 0; t < self->target_count; t++) {
        const clod_surrogate *one = self->targets[t].surrogate;
        const size_t room = one != NULL ? clod_surrogate_room(one) : 0;
        most = room > most ? room : most;
    }
    return clod_memory_alloc(most + more, sizeof(double));
}

static void interval(double *values, size_t stride, size_t count, double level, double *low,
                     double *high)
{
    gsl_sort(values, stride, count);
    const double tail = 0.5 * (1.0 - level);
    *low = gsl_stats_quantile_from_sorted_data(values, stride, count, tail);
    *high = gsl_stats_quantile_from_sorted_data(values, stride, count, 1.0 - tail);
}

/** Moments, interval and agreement of one parameter. `room` [count] */
static void look_at_parameter(const clod_plan *plan, clod_posterior *self, size_t k,
                              double *room)
{
    clod_posterior_parameter *to = &self->parameters[k];
    const double *samples = self->samples + k;
    const size_t d = self->dimensions;
    const clod_chain_series series = {samples, CHAINS, self->count / CHAINS, d};
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

double clod_posterior_noise(const clod_posterior *self, size_t target)
{
    const clod_surrogate *of = self->targets[target].surrogate;
    double means[CLOD_SURROGATE_MOST] = {0.0};
    for (size_t k = 0; k < self->dimensions; k++) {
        means[k] = self->parameters[k].mean;
    }
    return of != NULL ? clod_surrogate_noise(of, means) : (double)NAN;
}

clod_surrogate_value clod_posterior_told(const clod_posterior *self, size_t target,
                                         const double *place, double *room)
{
    double mean = 0.0, square = 0.0, inner = 0.0;
    const double draws = (double)self->draws;
    for (size_t i = 0; i < self->draws; i++) {
        const clod_surrogate_value one =
            clod_surrogate_at(self->targets[target].draws[i], place, room);
        mean += one.mean / draws;
        square += one.mean * one.mean / draws;
        inner += one.variance / draws;
    }
    return (clod_surrogate_value){mean, inner + fmax(0.0, square - mean * mean)};
}

const double *clod_posterior_sample(const clod_posterior *self, size_t i, size_t of)
{
    return self->samples + i * self->count / of * self->dimensions;
}

/** Room of `look`. */
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
        ask(self, place, self->chosen + i * self->count / at->looked * self->used, told,
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

/** Parameters, targets, and how well the targets go together. */
static bool look_at_all(const clod_plan *plan, clod_posterior *self, const sight *at,
                        clod_status *status)
{
    for (size_t k = 0; k < self->dimensions; k++) {
        look_at_parameter(plan, self, k, at->values);
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
    return true;
}

static bool look(const clod_posterior_runs *runs, clod_posterior *self, clod_status *status)
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
        .room = clod_posterior_room(self, 0),
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

/** Groups of targets, once their surrogates are there. */
static bool relate(const clod_posterior_runs *runs, clod_posterior *self, clod_status *status)
{
    const clod_surrogate **surrogates =
        clod_memory_alloc(self->target_count, sizeof *surrogates);
    for (size_t t = 0; t < self->target_count && surrogates != NULL; t++) {
        surrogates[t] = self->targets[t].surrogate;
    }
    const clod_misfit_runs of = {runs->plan, runs->points, runs->results, surrogates};
    self->misfit = surrogates != NULL ? clod_misfit_create(&of) : NULL;
    clod_memory_free(surrogates);
    return self->misfit != NULL ||
           clod_status_fail(status, CLOD_FAILED, "No memory for the posterior.");
}

static bool sample(const clod_posterior_runs *runs, clod_posterior *self, clod_status *status)
{
    const clod_plan *plan = runs->plan;
    density of = {self, clod_memory_alloc(self->target_count, sizeof *of.told),
                  clod_posterior_room(self, 0),
                  clod_memory_alloc(clod_misfit_room(self->misfit), sizeof(double))};
    const bool good = of.told != NULL && of.room != NULL && of.misfit_room != NULL;
    const clod_chain_setup setup = {.dimensions = self->dimensions,
                                    .chains = CHAINS,
                                    .warm_up = WARM_UP,
                                    .kept = self->count / CHAINS,
                                    .choices = self->used,
                                    .options = self->draws,
                                    .seed = (uint64_t)plan->seed,
                                    .density = log_density,
                                    .context = &of,
                                    .stop = runs->stop};
    const bool done =
        good && clod_chain_run(&setup, self->samples, self->chosen, &self->accepted);
    clod_memory_free(of.told);
    clod_memory_free(of.room);
    clod_memory_free(of.misfit_room);
    return good ? done || clod_stop_fail(status)
                : clod_status_fail(status, CLOD_FAILED, "No memory for the Markov chains.");
}

clod_posterior *clod_posterior_create(const clod_posterior_runs *runs, clod_status *status)
{
    const clod_plan *plan = runs->plan;
    clod_posterior *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the posterior.");
        return NULL;
    }
    const size_t d = plan->parameter_count;
    self->dimensions = d;
    self->target_count = plan->target_count;
    self->count = CHAINS * (size_t)plan->sampling.samples;
    self->targets = clod_memory_alloc(plan->target_count, sizeof *self->targets);
    self->parameters = clod_memory_alloc(d, sizeof *self->parameters);
    self->correlation = clod_memory_alloc(d * d, sizeof(double));
    self->samples = clod_memory_alloc(self->count * d, sizeof(double));
    for (size_t t = 0; t < plan->target_count && self->targets != NULL; t++) {
        self->targets[t].held_back = plan->targets[t].held_back;
        self->used += plan->targets[t].held_back ? 0 : 1;
    }
    self->chosen = clod_memory_alloc(self->count * self->used, sizeof *self->chosen);
    bool good = self->targets != NULL && self->chosen != NULL && self->parameters != NULL &&
                self->correlation != NULL && self->samples != NULL;
    if (!good) {
        self->target_count = self->targets == NULL ? 0 : self->target_count;
        clod_status_fail(status, CLOD_FAILED, "No memory for the posterior.");
    }
    good = good && fit(runs, self, status) && relate(runs, self, status) &&
           sample(runs, self, status) && look(runs, self, status);
    if (!good) {
        clod_posterior_destroy(&self);
    }
    return self;
}

void clod_posterior_destroy(clod_posterior **self)
{
    if (self == NULL || *self == NULL) {
        return;
    }
    for (size_t t = 0; t < (*self)->target_count; t++) {
        clod_surrogate_destroy(&(*self)->targets[t].surrogate);
        for (size_t i = 0; i < CLOD_POSTERIOR_DRAWS; i++) {
            clod_surrogate_destroy(&(*self)->targets[t].draws[i]);
        }
    }
    clod_misfit_destroy(&(*self)->misfit);
    clod_memory_free((*self)->targets);
    clod_memory_free((*self)->parameters);
    clod_memory_free((*self)->correlation);
    clod_memory_free((*self)->samples);
    clod_memory_free((*self)->chosen);
    clod_memory_free(*self);
    *self = NULL;
}
