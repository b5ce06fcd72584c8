/**
 * @file surrogate_draws.c
 * Hyperparameters and variance drawn as likely as the runs make them.
 */

#include <gsl/gsl_cdf.h>
#include <math.h>

#include "base/memory.h"
#include "base/random.h"
#include "calibrate/chain.h"
#include "calibrate/surrogate_fit.h"

// The more numbers a chain walks over, the longer it takes.
#define FEW 3       ///< numbers: so many, and fewer, are walked over in as many steps
#define WARM_UP 600 ///< steps before the first draw, for FEW numbers
#define APART 10    ///< steps from one draw to the next, for FEW numbers

_Static_assert(CLOD_SURROGATE_NUMBERS <= CLOD_CHAIN_MOST, "a chain takes all hyperparameters");

/** Hyperparameters as places in the unit cube. */
typedef struct cube {
    clod_surrogate *surrogate; ///< to try them with
    clod_surrogate_bounds bounds;
} cube;

static void put(const cube *self, clod_surrogate *to, const double *place)
{
    double numbers[CLOD_SURROGATE_NUMBERS];
    for (size_t k = 0; k < self->bounds.count; k++) {
        const double low = self->bounds.low[k], high = self->bounds.high[k];
        numbers[k] = low + (high - low) * place[k];
    }
    clod_surrogate_put(to, numbers);
}

static double log_density(void *context, const double *place, const size_t *choices)
{
    (void)choices;
    const cube *self = context;
    put(self, self->surrogate, place);
    return clod_surrogate_factor(self->surrogate) ? self->surrogate->likelihood : -HUGE_VAL;
}

/** Steps in proportion to the numbers that are walked over. */
static size_t steps_for(const cube *self, size_t few)
{
    const size_t numbers = self->bounds.count;
    return numbers > FEW ? few * numbers / FEW : few;
}

/** Chain of places from that of greatest likelihood; [count * apart][bounds.count], the draws apart */
static bool walk(const cube *self, const clod_surrogate *from, const clod_surrogate_dice *dice,
                 size_t count, const clod_stop *stop, double *places)
{
    double numbers[CLOD_SURROGATE_NUMBERS];
    clod_surrogate_get(from, numbers);
    for (size_t k = 0; k < self->bounds.count; k++) {
        const double low = self->bounds.low[k], high = self->bounds.high[k];
        numbers[k] = (numbers[k] - low) / (high - low);
    }
    const clod_chain_setup setup = {.dimensions = self->bounds.count,
                                    .chains = 1,
                                    .warm_up = steps_for(self, WARM_UP),
                                    .kept = count * steps_for(self, APART),
                                    .start = numbers,
                                    .seed = dice->seed,
                                    .stream = dice->stream,
                                    .density = log_density,
                                    .context = (void *)self,
                                    .stop = stop};
    double accepted;
    return clod_chain_run(&setup, places, NULL, &accepted);
}

/** One surrogate with drawn numbers; the sum of squares over its variance is a chi-square number. */
static clod_surrogate *draw(const cube *self, const clod_surrogate *from, const double *place,
                            double die, clod_status *status)
{
    clod_surrogate *one = clod_surrogate_copy(from, status);
    if (one == NULL) {
        return NULL;
    }
    if (place != NULL) {
        put(self, one, place);
        clod_surrogate_factor(one); // it could be factored when the chain was there
    }
    const double freedom = (double)(one->count - one->terms);
    one->variance =
        fmax(one->variance * freedom / gsl_cdf_chisq_Pinv(die, freedom), one->least);
    return one;
}

bool clod_surrogate_draw(const clod_surrogate *self, const clod_surrogate_dice *dice,
                         size_t count, const clod_stop *stop, clod_surrogate **draws,
                         clod_status *status)
{
    cube at = {.surrogate = clod_surrogate_copy(self, status)};
    if (at.surrogate == NULL) {
        return false;
    }
    clod_surrogate_bounds_of(self, &at.bounds);
    const size_t d = at.bounds.count;
    const size_t step = steps_for(&at, APART);
    double *places = clod_memory_alloc(count * step * d + 1, sizeof *places);
    bool good =
        places != NULL || clod_status_fail(status, CLOD_FAILED, "No memory for a surrogate.");
    if (good && d > 0 && !walk(&at, self, dice, count, stop, places)) {
        good = clod_stop_fail(status);
    }
    for (size_t i = 0; i < count && good; i++) {
        const double die =
            clod_random_uniform(dice->seed, CLOD_RANDOM_CALIBRATE, dice->stream + 1, i);
        draws[i] = draw(&at, self, d > 0 ? places + i * step * d : NULL, die, status);
        good = draws[i] != NULL;
    }
    clod_memory_free(places);
    clod_surrogate_destroy(&at.surrogate);
    return good;
}
