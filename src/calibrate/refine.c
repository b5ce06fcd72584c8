/**
 * @file refine.c
 * Where further runs stand for the posterior.
 */

#include <math.h>
#include <string.h>

#include "calibrate/posterior.h"

#define CANDIDATES 400 ///< samples of the posterior

/** How far samples are from the point that stands for them. */
typedef struct cover {
    const clod_posterior *posterior;
    double nearest[CANDIDATES]; ///< distance to the nearest point, of the range
} cover;

static const double *sample(const cover *self, size_t i)
{
    return clod_posterior_sample(self->posterior, i, CANDIDATES);
}

/** Distance of a sample to the nearest point, if there were one at a place. */
static double nearest_with(const cover *self, size_t i, const double *place)
{
    const double *at = sample(self, i);
    double squares = 0.0;
    for (size_t k = 0; k < self->posterior->dimensions; k++) {
        squares += (at[k] - place[k]) * (at[k] - place[k]);
    }
    return fmin(self->nearest[i], sqrt(squares));
}

/** There is a point at a place. */
static void put(cover *self, const double *place)
{
    for (size_t i = 0; i < CANDIDATES; i++) {
        self->nearest[i] = nearest_with(self, i, place);
    }
}

/** Sum of the distances with another point at a place. */
static double left_with(const cover *self, const double *place)
{
    double sum = 0.0;
    for (size_t i = 0; i < CANDIDATES; i++) {
        sum += nearest_with(self, i, place);
    }
    return sum;
}

/** The sample that leaves the least distance; NULL after a stop. */
static const double *choose(const cover *self, const clod_stop *stop)
{
    const double *best = NULL;
    double least = HUGE_VAL;
    for (size_t i = 0; i < CANDIDATES; i++) {
        if (clod_stop_asked(stop)) {
            return NULL;
        }
        const double left = left_with(self, sample(self, i));
        if (left < least) {
            least = left;
            best = sample(self, i);
        }
    }
    return best;
}

bool clod_posterior_refine(const clod_posterior *self, double *places, size_t done,
                           size_t count, const clod_stop *stop, clod_status *status)
{
    const size_t d = self->dimensions;
    cover of = {.posterior = self};
    for (size_t i = 0; i < CANDIDATES; i++) {
        of.nearest[i] = HUGE_VAL;
    }
    for (size_t k = 0; k < done; k++) {
        put(&of, places + k * d);
    }
    for (size_t k = done; k < done + count; k++) {
        const double *place = choose(&of, stop);
        if (place == NULL) {
            return clod_stop_fail(status);
        }
        memcpy(places + k * d, place, d * sizeof *places);
        put(&of, place);
    }
    return true;
}
