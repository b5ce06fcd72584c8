#include "config/sizes.h"

#include <math.h>

#include "base/memory.h"
#include "base/random.h"

/** Pieces of equal probability over which the volume of a normal distribution is averaged. */
#define MEAN_PIECES 2000

/** Probability of the standard normal distribution below x. */
static double normal_below(double x)
{
    return 0.5 * erfc(-x * M_SQRT1_2);
}

/**
 * x below which the standard normal distribution has the probability p <= 1/2.
 *
 * Newton on log P(x) = log p. P(-t) <= exp(-t^2/2)/2 puts the start left of the root, and
 * log P is concave and rising, so every iterate stays left of the root and rises to it.
 */
static double normal_quantile_low(double p)
{
    double x = -sqrt(fmax(0.0, -2.0 * log(2.0 * p)));
    for (int i = 0; i < 60; i++) {
        const double below = normal_below(x);
        const double density = exp(-0.5 * x * x) / sqrt(2.0 * M_PI);
        const double step = log(p / below) * below / density;
        x += step;
        if (fabs(step) <= 1e-15 * (1.0 + fabs(x))) {
            break;
        }
    }
    return x;
}

static double normal_quantile(double p)
{
    return p <= 0.5 ? normal_quantile_low(p) : -normal_quantile_low(1.0 - p);
}

bool clod_sizes_init_normal(clod_sizes *self, double mean, double sd, double min, double max,
                            clod_status *status)
{
    *self =
        (clod_sizes){.kind = CLOD_SIZE_NORMAL, .min = min, .max = max, .mean = mean, .sd = sd};
    if (min == max) {
        return true;
    }
    const double a = (min - mean) / sd;
    const double b = (max - mean) / sd;
    self->mirrored = a + b > 0.0; // upper tail: 1 - p would lose digits
    self->from = normal_below(self->mirrored ? -b : a);
    self->to = normal_below(self->mirrored ? -a : b);
    if (!(self->to - self->from > 1e-290)) {
        return clod_status_fail(status, CLOD_USAGE,
                                "radius: between min (%g m) and max (%g m) there is nothing of "
                                "a normal distribution with mean %g m and sd %g m; move the "
                                "mean between min and max",
                                min, max, mean, sd);
    }
    return true;
}

static bool init_sieve(clod_sizes *self, const clod_case_grains *from, clod_status *status)
{
    *self = (clod_sizes){.kind = CLOD_SIZE_SIEVE};
    self->class_count = from->sieve_count - 1;
    self->classes = clod_memory_alloc(self->class_count, sizeof *self->classes);
    if (self->classes == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the sieve table");
    }
    self->min = 0.5 * from->sieve[0].size;
    self->max = 0.5 * from->sieve[self->class_count].size;
    double total = 0.0;
    for (size_t c = 0; c < self->class_count; c++) {
        const clod_case_sieve *fine = &from->sieve[c];
        const clod_case_sieve *coarse = &from->sieve[c + 1];
        clod_sizes_class *k = &self->classes[c];
        k->small = 1.0 / (fine->size * fine->size * fine->size);
        k->large = 1.0 / (coarse->size * coarse->size * coarse->size);
        const double mass = coarse->passing - fine->passing;
        k->share = mass * (k->small - k->large) / log(coarse->size / fine->size);
        k->before = total;
        total += k->share;
    }
    for (size_t c = 0; c < self->class_count; c++) {
        self->classes[c].share /= total;
        self->classes[c].before /= total;
    }
    return true;
}

bool clod_sizes_init(clod_sizes *self, const clod_case_grains *from, clod_status *status)
{
    if (from->sizes == CLOD_SIZE_SIEVE) {
        return init_sieve(self, from, status);
    }
    const bool normal = from->sizes == CLOD_SIZE_NORMAL;
    const double mean = normal ? from->radius_mean : from->radius_min;
    const double sd = normal ? from->radius_sd : 1.0;
    if (!clod_sizes_init_normal(self, mean, sd, from->radius_min, from->radius_max, status)) {
        return false;
    }
    self->kind = (clod_size_kind)from->sizes;
    return true;
}

static double sieve_quantile(const clod_sizes *self, double u)
{
    size_t c = self->class_count - 1;
    while (c > 0 && (self->classes[c].share == 0.0 || u < self->classes[c].before)) {
        c--;
    }
    const clod_sizes_class *k = &self->classes[c];
    const double part = fmin(1.0, fmax(0.0, (u - k->before) / k->share));
    return 0.5 / cbrt(k->small - part * (k->small - k->large));
}

double clod_sizes_quantile(const clod_sizes *self, double u)
{
    double radius = self->min;
    if (self->kind == CLOD_SIZE_SIEVE) {
        radius = sieve_quantile(self, u);
    } else if (self->kind == CLOD_SIZE_UNIFORM) {
        radius = self->min + u * (self->max - self->min);
    } else if (self->min < self->max) {
        const double v = self->mirrored ? 1.0 - u : u;
        const double x = normal_quantile(self->from + v * (self->to - self->from));
        radius = self->mean + self->sd * (self->mirrored ? -x : x);
    }
    return fmin(fmax(radius, self->min), self->max);
}

double clod_sizes_radius(const clod_sizes *self, uint64_t seed, uint64_t id)
{
    return clod_sizes_quantile(self, clod_random_uniform(seed, CLOD_RANDOM_RADIUS, id, 0));
}

static double sphere(double radius)
{
    return 4.0 / 3.0 * M_PI * radius * radius * radius;
}

/** Mean of D^3 over the classes, 1/D^3 being uniform in each. */
static double sieve_mean_cube(const clod_sizes *self)
{
    double mean = 0.0;
    for (size_t c = 0; c < self->class_count; c++) {
        const clod_sizes_class *k = &self->classes[c];
        mean += k->share * log(k->small / k->large) / (k->small - k->large);
    }
    return mean;
}

double clod_sizes_mean_volume(const clod_sizes *self)
{
    const double a = self->min;
    const double b = self->max;
    if (self->kind == CLOD_SIZE_SIEVE) {
        return M_PI / 6.0 * sieve_mean_cube(self);
    }
    if (self->kind == CLOD_SIZE_UNIFORM) { // (b^4 - a^4) / (4 (b - a))
        return M_PI / 3.0 * (a + b) * (a * a + b * b);
    }
    double mean = 0.0;
    for (int k = 0; k < MEAN_PIECES; k++) {
        mean += sphere(clod_sizes_quantile(self, (k + 0.5) / MEAN_PIECES)) / MEAN_PIECES;
    }
    return mean;
}

double clod_sizes_largest_volume(const clod_sizes *self)
{
    return sphere(self->max);
}

size_t clod_sizes_count(const clod_sizes *self, uint64_t seed, uint64_t first_id, double volume,
                        double *put)
{
    size_t count = 0;
    double grain = 0.0;
    *put = 0.0;
    while (*put < volume || count == 0) {
        grain = sphere(clod_sizes_radius(self, seed, first_id + count++));
        *put += grain;
    }
    if (count > 1 && *put - volume > 0.5 * grain) {
        count--; // without the last grain it is nearer
        *put -= grain;
    }
    return count;
}

void clod_sizes_fini(clod_sizes *self)
{
    clod_memory_free(self->classes);
    *self = (clod_sizes){0};
}
