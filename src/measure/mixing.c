#include "measure/mixing.h"

#include <math.h>

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
    if (self.segregated > self.random) {
        self.index = (self.segregated - self.variance) / (self.segregated - self.random);
    }
    return self;
}
