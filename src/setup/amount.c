#include "setup/amount.h"

#include <math.h>

#include "base/memory.h"
#include "base/plural.h"

/** Bytes that a grain takes, at the very least: its rows in state and step (about 200), and its lists
 *  with histories (about 300; bench/results/memory.md). */
#define GRAIN_BYTES 500.0
/** Largest difference between the volume asked for and that of the grains, as a fraction. */
#define VOLUME_TOLERANCE 0.5

double clod_amount_expect(const clod_amount *self)
{
    return self->count > 0 ? (double)self->count
                           : fmax(1.0, self->volume / clod_sizes_mean_volume(self->sizes));
}

bool clod_amount_fits(const char *key, double grains, double share, clod_status *status)
{
    const double needed = grains * share * GRAIN_BYTES;
    const double memory = clod_memory_machine();
    return !(memory > 0.0) || needed <= memory ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: %.3g grains need at least %.3g GB of memory, and this machine "
                            "has %.3g GB (room for at most %.2g grains); take fewer or larger "
                            "grains",
                            key, grains, 1e-9 * needed, 1e-9 * memory,
                            memory / (share * GRAIN_BYTES));
}

size_t clod_amount_count(const clod_amount *self, uint64_t seed, uint64_t first_id,
                         clod_status *status)
{
    if (!clod_amount_fits(self->key, clod_amount_expect(self),
                          self->share > 0.0 ? self->share : 1.0, status)) {
        return 0;
    }
    if (self->count > 0) {
        return (size_t)self->count;
    }
    double put;
    const size_t count = clod_sizes_count(self->sizes, seed, first_id, self->volume, &put);
    if (fabs(put - self->volume) <= VOLUME_TOLERANCE * self->volume) {
        return count;
    }
    const double mean = clod_sizes_mean_volume(self->sizes) * self->density;
    clod_status_fail(status, CLOD_USAGE,
                     "%s: asks for %.3g kg of solid, but the nearest to it that these sizes "
                     "give is %zu grain%s of %.3g kg (a grain has %.3g kg in the mean, %.3g kg "
                     "at most); ask for more, or for smaller grains",
                     self->key, self->volume * self->density, count, clod_plural((double)count),
                     put * self->density, mean,
                     clod_sizes_largest_volume(self->sizes) * self->density);
    return 0;
}
