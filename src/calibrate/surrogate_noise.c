/**
 * @file surrogate_noise.c
 * How the noise of packings grows over the ranges.
 */

#include <math.h>

#include "calibrate/surrogate_fit.h"

double clod_surrogate_growth(const clod_surrogate *self, const double *inputs)
{
    double log = 0.0;
    for (size_t k = 0; k < self->dimensions; k++) {
        log += self->hyper.slopes[k] * (inputs[k] - 0.5);
    }
    return exp(log);
}

double clod_surrogate_prior(const clod_surrogate *self)
{
    // Signs of a diagonal do not matter: the change along each has the sum of the slopes' variances.
    const double variance =
        CLOD_SURROGATE_GROWTH * CLOD_SURROGATE_GROWTH / (double)self->dimensions;
    double square = 0.0;
    for (size_t k = 0; k < self->dimensions; k++) {
        square += self->hyper.slopes[k] * self->hyper.slopes[k];
    }
    return -0.5 * square / variance;
}

/** Standard deviation between packings in the middle of all ranges. */
static double middle(const clod_surrogate *self)
{
    const bool gaussian = self->kind == CLOD_SURROGATE_GAUSSIAN;
    return sqrt(self->variance * (gaussian ? self->hyper.nugget : 1.0));
}

double clod_surrogate_noise(const clod_surrogate *self, const double *inputs)
{
    return middle(self) * sqrt(clod_surrogate_growth(self, inputs));
}

void clod_surrogate_noise_ends(const clod_surrogate *self, double *least, double *greatest)
{
    double steps = 0.0;
    for (size_t k = 0; k < self->dimensions; k++) {
        steps += fabs(self->hyper.slopes[k]);
    }
    *least = middle(self) * exp(-0.25 * steps);
    *greatest = middle(self) * exp(0.25 * steps);
}

double clod_surrogate_noise_of(const clod_surrogate *self, size_t i)
{
    return clod_surrogate_noise(self, self->inputs + i * self->dimensions);
}

double clod_surrogate_slope(const clod_surrogate *self, size_t dimension)
{
    return self->hyper.slopes[dimension];
}
