/**
 * @file surrogate_fit.c
 * Hyperparameters of greatest restricted likelihood, by NLopt's Sbplx from three starts.
 */

#include "calibrate/surrogate_fit.h"

#include <math.h>
#include <nlopt.h>
#include <string.h>

// The parameters' ranges are 1 long: shorter waves than a tenth could not be told from noise with the
// runs that one can afford, longer ones than 10 are straight.
#define LEAST_LENGTH 0.1
#define MOST_LENGTH 10.0
#define LEAST_NUGGET 1e-6
#define MOST_NUGGET 1e4
#define STARTS 3
#define EVALUATIONS 150 ///< for each hyperparameter and start
#define TOLERANCE 1e-4  ///< of the log likelihood

/** What is searched, and who may stop it. */
typedef struct search {
    clod_surrogate *surrogate;
    const clod_stop *stop;
    nlopt_opt by;
} search;

/** Logs of lengths and nugget into the surrogate. */
static void put(clod_surrogate *self, const double *logs)
{
    for (size_t k = 0; k < self->dimensions; k++) {
        self->lengths[k] = exp(logs[k]);
    }
    self->nugget = exp(logs[self->dimensions]);
}

static double objective(unsigned count, const double *logs, double *gradient, void *context)
{
    (void)count;
    (void)gradient;
    const search *self = context;
    clod_surrogate *at = self->surrogate;
    if (clod_stop_asked(self->stop)) {
        nlopt_force_stop(self->by);
        return 1e300;
    }
    put(at, logs);
    return clod_surrogate_factor(at) ? -at->likelihood : 1e300;
}

static bool make_search(search *self)
{
    const unsigned count = (unsigned)self->surrogate->dimensions + 1;
    self->by = nlopt_create(NLOPT_LN_SBPLX, count);
    double low[CLOD_SURROGATE_MOST + 1];
    double high[CLOD_SURROGATE_MOST + 1];
    for (unsigned k = 0; k < count; k++) {
        const bool length = k + 1 < count;
        low[k] = log(length ? LEAST_LENGTH : LEAST_NUGGET);
        high[k] = log(length ? MOST_LENGTH : MOST_NUGGET);
    }
    if (self->by != NULL) {
        nlopt_set_min_objective(self->by, objective, self);
        nlopt_set_lower_bounds(self->by, low);
        nlopt_set_upper_bounds(self->by, high);
        nlopt_set_ftol_abs(self->by, TOLERANCE);
        nlopt_set_maxeval(self->by, (int)count * EVALUATIONS);
        nlopt_set_initial_step1(self->by, 0.5);
    }
    return self->by != NULL;
}

bool clod_surrogate_fit(clod_surrogate *self, const clod_stop *stop)
{
    static const double START[STARTS][2] = {{0.5, 0.1}, {2.0, 1.0}, {0.25, 0.01}};
    search of = {.surrogate = self, .stop = stop};
    if (!make_search(&of)) {
        return false;
    }
    double best[CLOD_SURROGATE_MOST + 1];
    double least = 1e300;
    for (int s = 0; s < STARTS; s++) {
        double logs[CLOD_SURROGATE_MOST + 1];
        double found = 1e300;
        for (size_t k = 0; k < self->dimensions; k++) {
            logs[k] = log(START[s][0]);
        }
        logs[self->dimensions] = log(START[s][1]);
        const nlopt_result ended = nlopt_optimize(of.by, logs, &found);
        if ((ended > 0 || ended == NLOPT_ROUNDOFF_LIMITED) && found < least) {
            least = found;
            memcpy(best, logs, sizeof best);
        }
    }
    nlopt_destroy(of.by);
    if (least >= 1e300) {
        return false;
    }
    put(self, best);
    return clod_surrogate_factor(self);
}
