#include "calibrate/posterior.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "calibrate/chain.h"
#include "calibrate/population.h"
#include "calibrate/posterior_look.h"

#define WARM_UP 2000
#define MEMBERS 2000       ///< of the population that chains begin at
#define DRAWN 1000000      ///< first stream of what surrogates of used targets do not know
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

static double log_density(void *context, const double *place, const size_t *chosen)
{
    const density *self = context;
    clod_posterior_look_ask(self->of, place, chosen, self->told, self->room);
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
    const bool memory = why.code == CLOD_FAILED;
    if (to->surrogate == NULL && plan->targets[number].held_back &&
        !memory) { // nothing depends on it
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
    if (why.code == CLOD_FAILED) {
        return clod_status_fail(status, CLOD_FAILED, "Target %s: %s",
                                plan->targets[number].name, why.text);
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

double *clod_posterior_room(const clod_posterior *self)
{
    size_t most = 1;
    for (size_t t = 0; t < self->target_count; t++) {
        const clod_surrogate *one = self->targets[t].surrogate;
        const size_t room = one != NULL ? clod_surrogate_room(one) : 0;
        most = room > most ? room : most;
    }
    return clod_memory_alloc(most, sizeof(double));
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

/** Chains from a population, and whether they went wherever it is. */
static bool walk(const clod_chain_setup *alone, clod_posterior *self, clod_status *status)
{
    clod_population population;
    bool good = clod_population_create(alone, MEMBERS, &population, status);
    clod_chain_setup setup = *alone;
    setup.population = &population;
    good = good && (clod_chain_run(&setup, self->samples, self->chosen, &self->accepted) ||
                    clod_stop_fail(status));
    self->missed = good ? clod_posterior_look_missed(self, population.places, MEMBERS) : 0.0;
    clod_population_fini(&population);
    return good;
}

static bool sample(const clod_posterior_runs *runs, clod_posterior *self, clod_status *status)
{
    const clod_plan *plan = runs->plan;
    density of = {self, clod_memory_alloc(self->target_count, sizeof *of.told),
                  clod_posterior_room(self),
                  clod_memory_alloc(clod_misfit_room(self->misfit), sizeof(double))};
    const bool good = of.told != NULL && of.room != NULL && of.misfit_room != NULL;
    const clod_chain_setup setup = {.dimensions = self->dimensions,
                                    .chains = CLOD_POSTERIOR_CHAINS,
                                    .warm_up = WARM_UP,
                                    .kept = self->count / CLOD_POSTERIOR_CHAINS,
                                    .choices = self->used,
                                    .options = self->draws,
                                    .seed = (uint64_t)plan->seed,
                                    .density = log_density,
                                    .context = &of,
                                    .stop = runs->stop};
    const bool done =
        good ? walk(&setup, self, status)
             : clod_status_fail(status, CLOD_FAILED, "No memory for the Markov chains.");
    clod_memory_free(of.told);
    clod_memory_free(of.room);
    clod_memory_free(of.misfit_room);
    return done;
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
    self->count = CLOD_POSTERIOR_CHAINS * (size_t)plan->sampling.samples;
    self->targets = clod_memory_alloc(plan->target_count, sizeof *self->targets);
    self->parameters = clod_memory_alloc(d, sizeof *self->parameters);
    self->correlation = clod_memory_alloc(d * d, sizeof(double));
    self->samples = clod_memory_alloc(self->count * d, sizeof(double));
    self->card = clod_memory_alloc(d, sizeof(double));
    for (size_t t = 0; t < plan->target_count && self->targets != NULL; t++) {
        self->targets[t].held_back = plan->targets[t].held_back;
        self->used += plan->targets[t].held_back ? 0 : 1;
    }
    self->chosen = clod_memory_alloc(self->count * self->used, sizeof *self->chosen);
    bool good = self->targets != NULL && self->chosen != NULL && self->parameters != NULL &&
                self->correlation != NULL && self->samples != NULL && self->card != NULL;
    if (!good) {
        self->target_count = self->targets == NULL ? 0 : self->target_count;
        clod_status_fail(status, CLOD_FAILED, "No memory for the posterior.");
    }
    good = good && fit(runs, self, status) && relate(runs, self, status) &&
           sample(runs, self, status) && clod_posterior_look(runs, self, status);
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
    clod_memory_free((*self)->card);
    clod_memory_free((*self)->chosen);
    clod_memory_free(*self);
    *self = NULL;
}
