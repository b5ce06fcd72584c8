/**
 * @file chain_agree.c
 * How well chains agree: split R-hat and effective number of samples.
 */

#include <math.h>

#include "base/memory.h"
#include "calibrate/chain.h"

/** Sample k of half chain h. */
static double value(const clod_chain_series *self, size_t h, size_t k)
{
    const size_t half = self->kept / 2;
    return self->values[((h / 2) * self->kept + (h % 2) * half + k) * self->stride];
}

/** What is known of the half chains. */
typedef struct halves {
    size_t count, length;
    double within; ///< mean variance inside a half chain
    double total;  ///< variance of all, overestimated while they disagree
    double *mean;  ///< [count] owned
} halves;

static bool look(const clod_chain_series *self, halves *to)
{
    to->count = 2 * self->chains;
    to->length = self->kept / 2;
    to->mean = clod_memory_alloc(to->count, sizeof *to->mean);
    if (to->mean == NULL) {
        return false;
    }
    const double n = (double)to->length;
    const double m = (double)to->count;
    double mean = 0.0;
    to->within = 0.0;
    for (size_t h = 0; h < to->count; h++) {
        double sum = 0.0;
        for (size_t k = 0; k < to->length; k++) {
            sum += value(self, h, k);
        }
        to->mean[h] = sum / n;
        mean += to->mean[h] / m;
        double square = 0.0;
        for (size_t k = 0; k < to->length; k++) {
            const double away = value(self, h, k) - to->mean[h];
            square += away * away;
        }
        to->within += square / (n - 1.0) / m;
    }
    double between = 0.0;
    for (size_t h = 0; h < to->count; h++) {
        between += (to->mean[h] - mean) * (to->mean[h] - mean) / (m - 1.0);
    }
    to->total = (n - 1.0) / n * to->within + between;
    return true;
}

double clod_chain_rhat(const clod_chain_series *series)
{
    halves all;
    if (!look(series, &all)) {
        return (double)NAN;
    }
    clod_memory_free(all.mean);
    return all.within > 0.0 ? sqrt(all.total / all.within) : (double)INFINITY;
}

/** Autocorrelation at a lag, over all half chains. */
static double correlation(const clod_chain_series *series, const halves *all, size_t lag)
{
    double covariance = 0.0;
    for (size_t h = 0; h < all->count; h++) {
        double sum = 0.0;
        for (size_t k = 0; k + lag < all->length; k++) {
            sum += (value(series, h, k) - all->mean[h]) *
                   (value(series, h, k + lag) - all->mean[h]);
        }
        covariance += sum / (double)all->length / (double)all->count;
    }
    return 1.0 - (all->within - covariance) / all->total;
}

double clod_chain_effective(const clod_chain_series *series)
{
    halves all;
    if (!look(series, &all)) {
        return (double)NAN;
    }
    double time = -1.0; // integrated autocorrelation time
    double least = HUGE_VAL;
    for (size_t lag = 0; lag + 1 < all.length && all.total > 0.0; lag += 2) {
        const double pair = (lag == 0 ? 1.0 : correlation(series, &all, lag)) +
                            correlation(series, &all, lag + 1);
        if (pair <= 0.0) {
            break;
        }
        least = fmin(least, pair);
        time += 2.0 * least;
    }
    clod_memory_free(all.mean);
    if (!(all.within > 0.0)) {
        return 0.0; // no chain has moved
    }
    const double count = (double)(all.count * all.length);
    return fmin(count, count / fmax(time, 1.0 / log10(fmax(count, 10.0))));
}
