/**
 * @file refine.c
 * Where further runs tell most about the posterior.
 */

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "calibrate/posterior.h"

#define CANDIDATES 400

/** Surrogates of the targets with runs added in thought. */
typedef struct thought {
    const clod_plan *plan;
    const clod_posterior *posterior;
    const clod_stop *stop;
    clod_surrogate **surrogates; ///< [targets] owned; NULL: that of the posterior
    double *room;
} thought;

static const clod_surrogate *surrogate_of(const thought *self, size_t t)
{
    return self->surrogates[t] != NULL ? self->surrogates[t]
                                       : self->posterior->targets[t].surrogate;
}

/** What is left to tell at a place: variance of the surrogates over that of the measurements. */
static double score(const thought *self, const double *place)
{
    double sum = 0.0;
    for (size_t t = 0; t < self->plan->target_count; t++) {
        const clod_plan_target *target = &self->plan->targets[t];
        if (!target->held_back) {
            sum += clod_surrogate_at(surrogate_of(self, t), place, self->room).variance /
                   clod_posterior_variance(target);
        }
    }
    return sum;
}

/** The candidate with the most left to tell; NULL after a stop. */
static const double *choose(const thought *self)
{
    const clod_posterior *from = self->posterior;
    const double *best = from->samples;
    double most = -1.0;
    for (size_t i = 0; i < CANDIDATES; i++) {
        const double *place = clod_posterior_sample(from, i, CANDIDATES);
        if (clod_stop_asked(self->stop)) {
            return NULL;
        }
        const double found = score(self, place);
        if (found > most) {
            most = found;
            best = place;
        }
    }
    return best;
}

/** Believe that a run at a place gives what the surrogates say. */
static bool believe(thought *self, const double *place, clod_status *status)
{
    for (size_t t = 0; t < self->plan->target_count; t++) {
        if (self->plan->targets[t].held_back) {
            continue;
        }
        clod_surrogate *more = clod_surrogate_believe(surrogate_of(self, t), place, status);
        if (more == NULL) {
            return false;
        }
        clod_surrogate_destroy(&self->surrogates[t]);
        self->surrogates[t] = more;
    }
    return true;
}

bool clod_posterior_refine(const clod_plan *plan, const clod_posterior *self, size_t count,
                           const clod_stop *stop, double *places, clod_status *status)
{
    thought of = {.plan = plan,
                  .posterior = self,
                  .stop = stop,
                  .surrogates = clod_memory_alloc(plan->target_count, sizeof *of.surrogates),
                  .room = clod_posterior_room(self, count)};
    bool good = of.surrogates != NULL && of.room != NULL;
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "No memory for further points.");
    }
    for (size_t k = 0; k < count && good; k++) {
        const double *place = choose(&of);
        if (place == NULL) {
            good = clod_stop_fail(status);
        } else {
            memcpy(places + k * self->dimensions, place, self->dimensions * sizeof *places);
            good = k + 1 == count || believe(&of, place, status);
        }
    }
    for (size_t t = 0; t < plan->target_count && of.surrogates != NULL; t++) {
        clod_surrogate_destroy(&of.surrogates[t]);
    }
    clod_memory_free(of.surrogates);
    clod_memory_free(of.room);
    return good;
}
