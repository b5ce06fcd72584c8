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

// The more numbers a chain walks over, the more steps lie between draws that are independent. A step takes the third
// power of the places: with more than FEW_PLACES there are fewer of them, but LEAST_APART.
#define FEW 3          ///< numbers: so many, and fewer, are walked over in as many steps
#define APART 100      ///< steps from one draw to the next, for FEW numbers and FEW_PLACES
#define LEAST_APART 10 ///< for FEW numbers and however many places
#define FEW_PLACES 64
#define WARM_UP 30        ///< times the steps between draws, before the first
#define LEAST_WARM_UP 600 ///< steps, for FEW numbers

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

/** Steps from one draw to the next. */
static size_t steps_apart(const cube *self)
{
    const double share = FEW_PLACES / fmax(FEW_PLACES, (double)self->surrogate->place_count);
    return steps_for(self, (size_t)fmax(LEAST_APART, APART * share * share));
}

/** Chain of places from that of greatest likelihood; [count * apart][bounds.count], the draws apart */
static bool walk(const cube *self, const clod_surrogate *from, const clod_surrogate_dice *dice,
                 size_t count, const clod_stop *stop, double *places)
{
    const size_t apart = steps_apart(self);
    const size_t least = steps_for(self, LEAST_WARM_UP);
    double numbers[CLOD_SURROGATE_NUMBERS];
    clod_surrogate_get(from, numbers);
    for (size_t k = 0; k < self->bounds.count; k++) {
        const double low = self->bounds.low[k], high = self->bounds.high[k];
        numbers[k] = (numbers[k] - low) / (high - low);
    }
    const clod_chain_setup setup = {.dimensions = self->bounds.count,
                                    .chains = 1,
                                    .warm_up =
                                        WARM_UP * apart > least ? WARM_UP * apart : least,
                                    .kept = count * apart,
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

/** Least effective number of the draws of any number; 0 where one never moved, NAN without memory. All steps of the
 *  chain tell its autocorrelation time t, so that r = (t - 1)/(t + 1) is the correlation over one step, if it falls as
 *  r^k over k; of draws m steps apart count (1 - r^m)/(1 + r^m). */
static double effective_of(const cube *self, const double *places, size_t count)
{
    const size_t d = self->bounds.count;
    const size_t apart = steps_apart(self);
    const double steps = (double)(count * apart);
    double least = (double)count;
    for (size_t k = 0; k < d; k++) {
        const clod_chain_series series = {places + k, 1, count * apart, d};
        const double all = clod_chain_effective(&series);
        if (!(all > 0.0)) {
            return all;
        }
        const double time = fmax(1.0, steps / all);
        const double tied = pow((time - 1.0) / (time + 1.0), (double)apart);
        least = fmin(least, (double)count * (1.0 - tied) / (1.0 + tied));
    }
    return least;
}

/** One uniform number in each of `count` equal parts of (0, 1), the parts in random order. Each is uniform by itself, and
 *  the tails are met as often as they should be. */
static void throw_dice(const clod_surrogate_dice *dice, size_t count, double *dies)
{
    for (size_t i = 0; i < count; i++) {
        const double within =
            clod_random_uniform(dice->seed, CLOD_RANDOM_CALIBRATE, dice->stream + 1, 2 * i);
        const double order =
            clod_random_uniform(dice->seed, CLOD_RANDOM_CALIBRATE, dice->stream + 1, 2 * i + 1);
        const size_t to = (size_t)(order * (double)(i + 1));
        dies[i] = ((double)i + within) / (double)count;
        const double swapped = dies[to];
        dies[to] = dies[i];
        dies[i] = swapped;
    }
}

bool clod_surrogate_draw(const clod_surrogate *self, const clod_surrogate_dice *dice,
                         size_t count, const clod_stop *stop, clod_surrogate **draws,
                         double *effective, clod_status *status)
{
    cube at = {.surrogate = clod_surrogate_copy(self, status)};
    if (at.surrogate == NULL) {
        return false;
    }
    clod_surrogate_bounds_of(self, &at.bounds);
    const size_t d = at.bounds.count;
    const size_t step = steps_apart(&at);
    double *places = clod_memory_alloc(count * step * d + 1, sizeof *places);
    double *dies = clod_memory_alloc(count, sizeof *dies);
    bool good = (places != NULL && dies != NULL) ||
                clod_status_fail(status, CLOD_FAILED, "No memory for a surrogate.");
    if (good && d > 0 && !walk(&at, self, dice, count, stop, places)) {
        good = clod_stop_fail(status);
    }
    *effective = good ? effective_of(&at, places, count) : 0.0;
    good = good && (!isnan(*effective) ||
                    clod_status_fail(status, CLOD_FAILED, "No memory for a surrogate."));
    if (good) {
        throw_dice(dice, count, dies);
    }
    for (size_t i = 0; i < count && good; i++) {
        draws[i] = draw(&at, self, d > 0 ? places + i * step * d : NULL, dies[i], status);
        good = draws[i] != NULL;
    }
    clod_memory_free(places);
    clod_memory_free(dies);
    clod_surrogate_destroy(&at.surrogate);
    return good;
}
