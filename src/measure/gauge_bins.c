#include "measure/gauge_bins.h"

#include <math.h>

/** Share of the samples from which on a bin belongs to the load. */
#define LOADED 0.5

clod_gauge_axis clod_gauge_axis_of(const clod_gauge *gauge, clod_vec3 along, int64_t count)
{
    double low, high;
    clod_gauge_extent(gauge, along, &low, &high);
    return (clod_gauge_axis){along, low, (high - low) / (double)count, (int)count};
}

/** Number of the bin that a position is in; the first or last for what is beyond. */
static int bin_of(const clod_gauge_axis *axis, double s)
{
    const double k = floor((s - axis->low) / axis->width);
    return (int)fmin(fmax(k, 0.0), axis->count - 1);
}

/** Share of a sphere's volume that is below t radii from its centre. */
static double share_below(double t)
{
    const double u = fmin(fmax(t, -1.0), 1.0);
    return 0.25 * (2.0 + u * (3.0 - u * u));
}

/** What of a grain is in bin k. */
static void add_slice(clod_gauge_slice *bin, const clod_gauge_axis *axis, int k, double s,
                      double h, double r, double m)
{
    const double from = axis->low + k * axis->width, to = from + axis->width;
    const double below = k > 0 ? share_below((from - s) / r) : 0.0;
    const double mass = m * ((k + 1 < axis->count ? share_below((to - s) / r) : 1.0) - below);
    const double beside =
        fmax(0.0, fmax(k > 0 ? from - s : 0.0, k + 1 < axis->count ? s - to : 0.0));
    if (beside >= r) {
        return;
    }
    const double half = sqrt(r * r - beside * beside);
    bin->lower = bin->seen ? fmin(bin->lower, h - half) : h - half;
    bin->upper = bin->seen ? fmax(bin->upper, h + half) : h + half;
    bin->seen = true;
    clod_exact_add(&bin->mass, mass);
    clod_exact_add(&bin->moment, mass * h);
}

void clod_gauge_bins_add(clod_gauge_slice *slices, const clod_gauge *gauge,
                         const clod_gauge_axis *axis, const double position[4], double mass)
{
    const clod_vec3 center = clod_vec3_of(position);
    const double s = clod_vec3_dot(center, axis->along), h = clod_vec3_dot(center, gauge->up);
    const double r = position[3];
    const int last = bin_of(axis, s + r);
    for (int k = bin_of(axis, s - r); k <= last; k++) {
        add_slice(&slices[k], axis, k, s, h, r, mass);
    }
}

void clod_gauge_bins_merge(clod_gauge_slice *self, const clod_gauge_slice *other)
{
    if (other->seen) {
        self->lower = self->seen ? fmin(self->lower, other->lower) : other->lower;
        self->upper = self->seen ? fmax(self->upper, other->upper) : other->upper;
        self->seen = true;
    }
    clod_exact_merge(&self->mass, &other->mass);
    clod_exact_merge(&self->moment, &other->moment);
}

void clod_gauge_bins_take(clod_gauge_bins *self, const clod_gauge_axis *axis,
                          const clod_gauge_slice *slices)
{
    self->samples += 1.0;
    for (int k = 0; k < axis->count; k++) {
        if (slices[k].seen) {
            self->seen[k] += 1.0;
            self->lower[k] += slices[k].lower;
            self->upper[k] += slices[k].upper;
            self->mass[k] += clod_exact_value(&slices[k].mass);
            self->moment[k] += clod_exact_value(&slices[k].moment);
        }
    }
}

static double over(double a, double b)
{
    return b > 0.0 ? a / b : (double)NAN;
}

clod_gauge_bin clod_gauge_bins_of(const clod_gauge_bins *self, const clod_gauge_axis *axis,
                                  int k)
{
    return (clod_gauge_bin){.at = axis->low + (k + 0.5) * axis->width,
                            .share = over(self->seen[k], self->samples),
                            .lower = over(self->lower[k], self->seen[k]),
                            .upper = over(self->upper[k], self->seen[k]),
                            .mean = over(self->moment[k], self->mass[k]),
                            .mass = over(self->mass[k], self->samples)};
}

static bool is_loaded(const clod_gauge_bins *self, int k)
{
    return self->seen[k] > 0.0 && self->seen[k] >= LOADED * self->samples;
}

/** Determinant of the matrix of columns a, b, c. */
static double determinant(const double a[3], const double b[3], const double c[3])
{
    return clod_vec3_dot(clod_vec3_of(a), clod_vec3_cross(clod_vec3_of(b), clod_vec3_of(c)));
}

/** Coefficient of u^2 of the parabola through the upper edges by least squares; u is -1 and 1 at
 *  the edges of the load. */
static double curvature(const clod_gauge_bins *self, int first, int last)
{
    double moment[5] = {0}, right[3] = {0};
    const double width = last + 1 - first;
    for (int k = first; k <= last; k++) {
        const double u = (2.0 * (k - first) + 1.0) / width - 1.0;
        const double h = self->upper[k] / (self->seen[k] > 0.0 ? self->seen[k] : 1.0);
        double power = is_loaded(self, k) ? 1.0 : 0.0;
        for (int p = 0; p < 5; p++, power *= u) {
            moment[p] += power;
            if (p < 3) {
                right[p] += power * h;
            }
        }
    }
    return determinant(moment, &moment[1], right) / determinant(moment, &moment[1], &moment[2]);
}

clod_gauge_section clod_gauge_bins_section(const clod_gauge_bins *self,
                                           const clod_gauge_axis *axis)
{
    clod_gauge_section section = {.surcharge = (double)NAN};
    int first = -1, last = -1, loaded = 0;
    for (int k = 0; k < axis->count; k++) {
        section.area += over(self->upper[k] - self->lower[k], self->samples) * axis->width;
        if (is_loaded(self, k)) {
            first = first < 0 ? k : first;
            last = k;
            loaded++;
        }
    }
    section.width = loaded > 0 ? (last + 1 - first) * axis->width : 0.0;
    if (loaded >= 3) {
        section.surcharge = atan(-4.0 * curvature(self, first, last) / section.width);
    }
    return section;
}
