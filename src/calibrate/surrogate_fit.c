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
#define NUMBERS (2 * CLOD_SURROGATE_MOST + 1)
#define EVALUATIONS 150 ///< for each hyperparameter and start
#define TOLERANCE 1e-4  ///< of the log likelihood

/** What is searched, and who may stop it. */
typedef struct search {
    clod_surrogate *surrogate;
    const clod_stop *stop;
    nlopt_opt by;
    size_t lengths, nuggets, slopes; ///< how many of each: these are the numbers, in this order
} search;

/** Logs of lengths and nugget, and slopes, into the surrogate. */
static void put(const search *self, const double *numbers)
{
    clod_surrogate_hyper *to = &self->surrogate->hyper;
    for (size_t k = 0; k < self->lengths; k++) {
        to->lengths[k] = exp(*numbers++);
    }
    for (size_t k = 0; k < self->nuggets; k++) {
        to->nugget = exp(*numbers++);
    }
    for (size_t k = 0; k < self->slopes; k++) {
        to->slopes[k] = *numbers++;
    }
}

/** A number for each length, the nugget and each slope. */
static void fill(const search *self, double length, double nugget, double slope,
                 double *numbers)
{
    for (size_t k = 0; k < self->lengths; k++) {
        *numbers++ = length;
    }
    for (size_t k = 0; k < self->nuggets; k++) {
        *numbers++ = nugget;
    }
    for (size_t k = 0; k < self->slopes; k++) {
        *numbers++ = slope;
    }
}

static unsigned count_of(const search *self)
{
    return (unsigned)(self->lengths + self->nuggets + self->slopes);
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
    put(self, numbers);
    return clod_surrogate_factor(at) ? -at->likelihood : 1e300;
}

static bool make_search(search *self)
{
    const unsigned count = count_of(self);
    const double steepest =
        MOST_GROWTHS * CLOD_SURROGATE_GROWTH / sqrt((double)self->surrogate->dimensions);
    self->by = nlopt_create(NLOPT_LN_SBPLX, count);
    double low[NUMBERS];
    double high[NUMBERS];
    fill(self, log(LEAST_LENGTH), log(LEAST_NUGGET), -steepest, low);
    fill(self, log(MOST_LENGTH), log(MOST_NUGGET), steepest, high);
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

/** The likeliest numbers from each start; false where none was found. */
static bool find(const search *self, double *best)
{
    static const double START[STARTS][2] = {{0.5, 0.1}, {2.0, 1.0}, {0.25, 0.01}};
    const int starts = self->lengths > 0 ? STARTS : 1;
    double least = 1e300;
    for (int s = 0; s < starts; s++) {
        double numbers[NUMBERS];
        double found = 1e300;
        fill(self, log(START[s][0]), log(START[s][1]), 0.0, numbers);
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
    const bool gaussian = self->kind == CLOD_SURROGATE_GAUSSIAN;
    const bool told = self->count - self->terms > 1 + self->dimensions;
    search of = {.surrogate = self,
                 .stop = stop,
                 .lengths = gaussian ? self->dimensions : 0,
                 .nuggets = gaussian ? 1 : 0,
                 .slopes = told ? self->dimensions : 0};
    if (count_of(&of) == 0) {
        return clod_surrogate_factor(self);
    }
    double best[NUMBERS];
    const bool found = make_search(&of) && find(&of, best);
    nlopt_destroy(of.by);
    if (!found) {
        return false;
    }
    put(&of, best);
    return clod_surrogate_factor(self);
}
