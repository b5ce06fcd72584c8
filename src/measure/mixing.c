#include "measure/mixing.h"

#include <math.h>

/** The index of the variances. */
static void set_index(clod_mixing *self)
{
    if (self->segregated > self->random) {
        self->index = (self->segregated - self->variance) / (self->segregated - self->random);
    }
}

clod_mixing clod_mixing_of(const clod_mixing_sample *samples, size_t count)
{
    int64_t grains = 0, first = 0, used = 0;
    for (size_t k = 0; k < count; k++) {
        grains += samples[k].grains;
        first += samples[k].first;
        used += samples[k].grains > 0;
    }
    const double all = (double)grains, p = (double)first / all;
    double sum = 0.0; // in the order of the samples
    for (size_t k = 0; k < count; k++) {
        if (samples[k].grains > 0) {
            const double n = (double)samples[k].grains;
            const double off = (double)samples[k].first / n - p;
            sum += n * off * off;
        }
    }
    clod_mixing self = {.variance = sum / all,
                        .segregated = p * (1.0 - p),
                        .random = (double)NAN,
                        .index = (double)NAN,
                        .share = p,
                        .grains = all / (double)used};
    if (used > 1) {
        self.random = self.segregated * (double)(used - 1) / (all - 1.0);
    }
    set_index(&self);
    return self;
}

clod_mixing clod_mixing_of_mass(const clod_mixing_weighed *samples, size_t count)
{
    int64_t grains = 0, used = 0;
    double mass[2] = {0.0, 0.0}, square[2] = {0.0, 0.0}; // in the order of the samples
    for (size_t k = 0; k < count; k++) {
        grains += samples[k].grains;
        used += samples[k].grains > 0;
        for (int kind = 0; kind < 2; kind++) {
            mass[kind] += samples[k].mass[kind];
            square[kind] += samples[k].square[kind];
        }
    }
    const double all = mass[0] + mass[1], p = mass[0] / all, q = mass[1] / all;
    double sum = 0.0;
    for (size_t k = 0; k < count; k++) {
        if (samples[k].grains > 0) {
            const double *m = samples[k].mass;
            const double off = m[0] * q - m[1] * p; // M_k (p_k - p)
            sum += off * off / (m[0] + m[1]);
        }
    }
    clod_mixing self = {.variance = sum / all,
                        .segregated = p * q,
                        .random = (double)NAN,
                        .index = (double)NAN,
                        .share = p,
                        .grains = (double)grains / (double)used};
    if (used > 1) {
        self.random = (double)grains / ((double)grains - 1.0) * (double)(used - 1) *
                      (q * q * square[0] + p * p * square[1]) / (all * all);
    }
    set_index(&self);
    return self;
}
