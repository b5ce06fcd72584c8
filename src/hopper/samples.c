#include "hopper/samples.h"

#include <math.h>
#include <stdlib.h>

#define LEAST 3     ///< outlets that make a line
#define ALONG 1e-12 ///< part of a column's square below which others have it all
#define CLOSE                                                                                  \
    (1e-12 * 1e-12) ///< variance over the square of the mean below which all are one value

double clod_samples_quantile(const double *sorted, size_t count, double share)
{
    const double at = share * (double)(count - 1);
    const size_t k = (size_t)at;
    const double part = at - (double)k;
    if (k + 1 >= count || part == 0.0 || sorted[k] == sorted[k + 1]) {
        return sorted[k];
    }
    return sorted[k] + part * (sorted[k + 1] - sorted[k]);
}

double clod_samples_quantile_error(const double *sorted, size_t count, double share)
{
    const double off = sqrt(share * (1.0 - share) / (double)count);
    const double low = clod_samples_quantile(sorted, count, fmax(0.0, share - off));
    const double high = clod_samples_quantile(sorted, count, fmin(1.0, share + off));
    return low == high ? 0.0 : 0.5 * (high - low);
}

void clod_samples_values(const clod_solid *solid, const clod_solid_state *state,
                         double value[CLOD_SOLID_CURVES])
{
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        const double stress = k == CLOD_SOLID_WALL ? state->sigma_w : state->sigma_1;
        value[k] = clod_curve_at(&solid->curves[k], stress);
    }
}

static int by_size(const void *left, const void *right)
{
    const double a = ((const clod_samples_item *)left)->value;
    const double b = ((const clod_samples_item *)right)->value;
    return (a > b) - (a < b);
}

/** Whether all values are one, but for round-off. */
static bool are_same(const double *value, size_t count)
{
    double mean = 0.0;
    double squares = 0.0;
    for (size_t i = 0; i < count; i++) {
        mean += value[i] / (double)count;
    }
    for (size_t i = 0; i < count; i++) {
        squares += (value[i] - mean) * (value[i] - mean);
    }
    // of infinite ones among others this is no number
    return isfinite(mean) ? squares <= CLOSE * (double)count * mean * mean : false;
}

/** Put ranks, less their mean, in the place of values; equal ones share the mean of their ranks. */
static void take_ranks(double *value, size_t count, clod_samples_item *room)
{
    for (size_t i = 0; i < count; i++) {
        room[i] = (clod_samples_item){value[i], i};
    }
    qsort(room, count, sizeof *room, by_size);
    for (size_t i = 0, next; i < count; i = next) {
        for (next = i + 1; next < count && room[next].value == room[i].value;) {
            next++;
        }
        for (size_t k = i; k < next; k++) {
            value[room[k].at] = 0.5 * ((double)i + (double)next - (double)count);
        }
    }
}

static double product(const double *left, const double *right, size_t count)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) {
        sum += left[i] * right[i];
    }
    return sum;
}

/** Take from a column what is along another one. */
static void take_off(double *from, const double *along, double length, size_t count)
{
    const double part = product(from, along, count) / length;
    for (size_t i = 0; i < count; i++) {
        from[i] -= part * along[i];
    }
}

double clod_samples_shares(double *const column[CLOD_SOLID_CURVES], double *outlet,
                           size_t count, clod_samples_item *room,
                           double share[CLOD_SOLID_CURVES])
{
    bool varies[CLOD_SOLID_CURVES] = {false};
    const bool known = count >= LEAST && !are_same(outlet, count);
    take_ranks(outlet, count, room);
    const double all = product(outlet, outlet, count);
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        share[k] = (double)NAN;
        varies[k] = known && column[k] != NULL && !are_same(column[k], count);
        if (varies[k]) {
            take_ranks(column[k], count, room);
            const double both = product(column[k], outlet, count);
            share[k] = both * both / (product(column[k], column[k], count) * all);
        }
    }
    // least squares of the outlet's ranks on those of all curves: one orthogonal column at a time
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        const double whole = varies[k] ? product(column[k], column[k], count) : 0.0;
        for (size_t j = 0; j < k && varies[k]; j++) {
            if (varies[j]) {
                take_off(column[k], column[j], product(column[j], column[j], count), count);
            }
        }
        const double left = varies[k] ? product(column[k], column[k], count) : 0.0;
        varies[k] = varies[k] && left > ALONG * whole;
        if (varies[k]) {
            take_off(outlet, column[k], left, count);
        }
    }
    return known ? product(outlet, outlet, count) / all : (double)NAN;
}
