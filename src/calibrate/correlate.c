#include "calibrate/correlate.h"

#include <math.h>
#include <stdbool.h>

/** Sums over rows that two numbers have. */
typedef struct sums {
    double own, other, both;
    size_t rows, blocks;
} sums;

static sums add_up(const clod_correlate_rows *self, size_t a, size_t b)
{
    sums of = {0};
    size_t last = self->rows; // block of the row before: none
    for (size_t row = 0; row < self->rows; row++) {
        const double x = self->values[row * self->count + a];
        const double y = self->values[row * self->count + b];
        if (isfinite(x) && isfinite(y)) {
            of.own += x * x;
            of.other += y * y;
            of.both += x * y;
            of.rows++;
            of.blocks += row / self->block != last ? 1 : 0;
            last = row / self->block;
        }
    }
    return of;
}

double clod_correlate(const clod_correlate_rows *self, double *r)
{
    const size_t n = self->count;
    double least = (double)INFINITY;
    for (size_t a = 0; a < n; a++) {
        r[a * n + a] = 1.0;
        for (size_t b = 0; b < a; b++) {
            const sums of = add_up(self, a, b);
            const size_t lost = self->lost > 0 ? self->lost : of.blocks;
            const double found = of.both / sqrt(of.own * of.other);
            const bool told = of.rows > lost && isfinite(found);
            least = told ? fmin(least, (double)(of.rows - lost)) : least;
            r[a * n + b] = told ? found : (double)NAN;
            r[b * n + a] = r[a * n + b];
        }
    }
    if (isfinite(least)) {
        return least;
    }
    for (size_t k = 0; k < n * n; k++) {
        r[k] = k % (n + 1) == 0 ? 1.0 : 0.0;
    }
    return 0.0;
}

void clod_correlate_complete(double *r, const double *other, size_t count)
{
    double sum = 0.0, told = 0.0;
    for (size_t k = 0; k < count * count; k++) {
        const bool known = k % (count + 1) != 0 && isfinite(r[k]);
        sum += known ? r[k] : 0.0;
        told += known ? 1.0 : 0.0;
    }
    for (size_t k = 0; k < count * count; k++) {
        if (!isfinite(r[k])) {
            r[k] = other != NULL ? other[k] : fmax(0.0, sum / told);
        }
    }
}

double clod_correlate_join(double *r, double degrees, const double *other, double more,
                           size_t count)
{
    const double all = degrees + more;
    for (size_t k = 0; k < count * count && all > 0.0; k++) {
        r[k] = (degrees * r[k] + more * other[k]) / all;
    }
    return all;
}

void clod_correlate_shrink(double *r, size_t count, double degrees)
{
    double mean = 0.0;
    for (size_t a = 0; a < count; a++) {
        for (size_t b = 0; b < a; b++) {
            mean += 2.0 * r[a * count + b] / (double)(count * (count - 1));
        }
    }
    const double equal = fmax(0.0, mean) * degrees / (degrees + 1.0);
    const double weight = (double)count / (degrees + (double)count);
    for (size_t k = 0; k < count * count; k++) {
        r[k] = k % (count + 1) == 0 ? 1.0 : (1.0 - weight) * r[k] + weight * equal;
    }
}

double clod_correlate_pooled(const double *r, size_t count, double degrees)
{
    double squares =
        0.0; // two estimates of variances have the square of r as their correlation
    for (size_t k = 0; k < count * count; k++) {
        squares += r[k] * r[k];
    }
    return degrees * (double)(count * count) / squares;
}

double clod_correlate_factor(double *v, size_t count)
{
    double sum = 0.0;
    for (size_t a = 0; a < count; a++) {
        for (size_t b = 0; b <= a; b++) {
            double left = v[a * count + b];
            for (size_t k = 0; k < b; k++) {
                left -= v[a * count + k] * v[b * count + k];
            }
            v[a * count + b] = a == b ? sqrt(left) : left / v[b * count + b];
        }
        sum += 2.0 * log(v[a * count + a]);
    }
    return sum;
}

double clod_correlate_distance(const double *factor, size_t count, double *x)
{
    double square = 0.0;
    for (size_t a = 0; a < count; a++) {
        for (size_t k = 0; k < a; k++) {
            x[a] -= factor[a * count + k] * x[k];
        }
        x[a] /= factor[a * count + a];
        square += x[a] * x[a];
    }
    return square;
}
