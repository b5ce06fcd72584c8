/**
 * @file surrogate_fit.c
 * Hyperparameters of greatest restricted likelihood, by NLopt's Sbplx: lengths, nugget and slopes of a Gaussian
 * process from three starts, slopes of a polynomial from one.
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
#define MOST_GROWTHS 4.0 ///< of slopes, in deviations of their prior
#define STARTS 3
#define EVALUATIONS 150 ///< for each hyperparameter and start
#define TOLERANCE 1e-4  ///< of the log likelihood

/** What is searched, and who may stop it. */
typedef struct search {
    clod_surrogate *surrogate;
    const clod_stop *stop;
    nlopt_opt by;
    clod_surrogate_bounds bounds;
} search;

/** How many numbers of each kind are fitted. */
typedef struct counts {
    size_t lengths, nuggets, slopes;
} counts;

static counts counts_of(const clod_surrogate *self)
{
    const bool gaussian = self->kind == CLOD_SURROGATE_GAUSSIAN;
    const bool told = self->count - self->terms > 1 + self->dimensions;
    return (counts){gaussian ? self->dimensions : 0, gaussian ? 1 : 0,
                    told ? self->dimensions : 0};
}

void clod_surrogate_put(clod_surrogate *self, const double *numbers)
{
    const counts of = counts_of(self);
    for (size_t k = 0; k < of.lengths; k++) {
        self->hyper.lengths[k] = exp(*numbers++);
    }
    for (size_t k = 0; k < of.nuggets; k++) {
        self->hyper.nugget = exp(*numbers++);
    }
    for (size_t k = 0; k < of.slopes; k++) {
        self->hyper.slopes[k] = *numbers++;
    }
}

void clod_surrogate_get(const clod_surrogate *self, double *numbers)
{
    const counts of = counts_of(self);
    for (size_t k = 0; k < of.lengths; k++) {
        *numbers++ = log(self->hyper.lengths[k]);
    }
    for (size_t k = 0; k < of.nuggets; k++) {
        *numbers++ = log(self->hyper.nugget);
    }
    for (size_t k = 0; k < of.slopes; k++) {
        *numbers++ = self->hyper.slopes[k];
    }
}

/** A number for each length, the nugget and each slope. @return how many */
static size_t fill(const clod_surrogate *self, double length, double nugget, double slope,
                   double *numbers)
{
    const counts of = counts_of(self);
    size_t at = 0;
    for (size_t k = 0; k < of.lengths; k++) {
        numbers[at++] = length;
    }
    for (size_t k = 0; k < of.nuggets; k++) {
        numbers[at++] = nugget;
    }
    for (size_t k = 0; k < of.slopes; k++) {
        numbers[at++] = slope;
    }
    return at;
}

void clod_surrogate_bounds_of(const clod_surrogate *self, clod_surrogate_bounds *bounds)
{
    const double steepest =
        MOST_GROWTHS * CLOD_SURROGATE_GROWTH / sqrt((double)self->dimensions);
    fill(self, log(LEAST_LENGTH), log(LEAST_NUGGET), -steepest, bounds->low);
    bounds->count = fill(self, log(MOST_LENGTH), log(MOST_NUGGET), steepest, bounds->high);
}

static double objective(unsigned count, const double *numbers, double *gradient, void *context)
{
    (void)count;
    (void)gradient;
    const search *self = context;
    clod_surrogate *at = self->surrogate;
    if (clod_stop_asked(self->stop)) {
        nlopt_force_stop(self->by);
        return 1e300;
    }
    clod_surrogate_put(at, numbers);
    return clod_surrogate_factor(at) ? -at->likelihood : 1e300;
}

static bool make_search(search *self)
{
    const unsigned count = (unsigned)self->bounds.count;
    self->by = nlopt_create(NLOPT_LN_SBPLX, count);
    if (self->by != NULL) {
        nlopt_set_min_objective(self->by, objective, self);
        nlopt_set_lower_bounds(self->by, self->bounds.low);
        nlopt_set_upper_bounds(self->by, self->bounds.high);
        nlopt_set_ftol_abs(self->by, TOLERANCE);
        nlopt_set_maxeval(self->by, (int)count * EVALUATIONS);
        nlopt_set_initial_step1(self->by, 0.5);
    }
    return self->by != NULL;
}

/** The likeliest numbers from each start; false where none was found. */
static bool find(const search *self, double *best)
{
    static const double START[STARTS][2] = {{0.5, 0.1}, {2.0, 1.0}, {0.25, 0.01}};
    const int starts = self->surrogate->kind == CLOD_SURROGATE_GAUSSIAN ? STARTS : 1;
    double least = 1e300;
    for (int s = 0; s < starts; s++) {
        double numbers[CLOD_SURROGATE_NUMBERS];
        double found = 1e300;
        fill(self->surrogate, log(START[s][0]), log(START[s][1]), 0.0, numbers);
        const nlopt_result ended = nlopt_optimize(self->by, numbers, &found);
        if ((ended > 0 || ended == NLOPT_ROUNDOFF_LIMITED) && found < least) {
            least = found;
            memcpy(best, numbers, sizeof numbers);
        }
    }
    return least < 1e300;
}

bool clod_surrogate_fit(clod_surrogate *self, const clod_stop *stop)
{
    search of = {.surrogate = self, .stop = stop};
    clod_surrogate_bounds_of(self, &of.bounds);
    if (of.bounds.count == 0) {
        return clod_surrogate_factor(self);
    }
    double best[CLOD_SURROGATE_NUMBERS];
    const bool found = make_search(&of) && find(&of, best);
    nlopt_destroy(of.by);
    if (!found) {
        return false;
    }
    clod_surrogate_put(self, best);
    return clod_surrogate_factor(self);
}
