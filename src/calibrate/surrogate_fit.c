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
    clod_surrogate *self = context;
    put(self, logs);
    return clod_surrogate_factor(self) ? -self->likelihood : 1e300;
}

static nlopt_opt make_search(clod_surrogate *self)
{
    const unsigned count = (unsigned)self->dimensions + 1;
    nlopt_opt search = nlopt_create(NLOPT_LN_SBPLX, count);
    double low[CLOD_SURROGATE_MOST + 1];
    double high[CLOD_SURROGATE_MOST + 1];
    for (unsigned k = 0; k < count; k++) {
        const bool length = k + 1 < count;
        low[k] = log(length ? LEAST_LENGTH : LEAST_NUGGET);
        high[k] = log(length ? MOST_LENGTH : MOST_NUGGET);
    }
    if (search != NULL) {
        nlopt_set_min_objective(search, objective, self);
        nlopt_set_lower_bounds(search, low);
        nlopt_set_upper_bounds(search, high);
        nlopt_set_ftol_abs(search, TOLERANCE);
        nlopt_set_maxeval(search, (int)count * EVALUATIONS);
        nlopt_set_initial_step1(search, 0.5);
    }
    return search;
}

bool clod_surrogate_fit(clod_surrogate *self)
{
    static const double START[STARTS][2] = {{0.5, 0.1}, {2.0, 1.0}, {0.25, 0.01}};
    nlopt_opt search = make_search(self);
    if (search == NULL) {
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
        const nlopt_result ended = nlopt_optimize(search, logs, &found);
        if ((ended > 0 || ended == NLOPT_ROUNDOFF_LIMITED) && found < least) {
            least = found;
            memcpy(best, logs, sizeof best);
        }
    }
    nlopt_destroy(search);
    if (least >= 1e300) {
        return false;
    }
    put(self, best);
    return clod_surrogate_factor(self);
}
