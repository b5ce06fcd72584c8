#pragma once
// Shared by the tests of the evaluation: points on a line, normal random numbers.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/fields.h"
#include "base/random.h"
#include "clod/locus.h"

#define PI 3.14159265358979323846
#define DEG (PI / 180.0)

/** Points exactly on tau = c + sigma tan(phi), all with the same preshear. */
static inline void points_on_line(double c, double phi, double sigma_p, double tau_p,
                                  const double *sigma, size_t count, clod_locus_point *points)
{
    for (size_t i = 0; i < count; i++) {
        points[i] = (clod_locus_point){.sigma_p = sigma_p,
                                       .tau_p = tau_p,
                                       .sigma_s = sigma[i],
                                       .tau_s = c + sigma[i] * tan(phi)};
    }
}

static inline double normal(uint64_t seed, uint64_t item, uint64_t draw)
{
    return clod_random_normal(seed, CLOD_RANDOM_TEST, item, 2 * draw);
}

/** Means over trials of the fields that follow from points, of their squares, and of the squares
 *  of their reported errors. */
typedef struct trial_means {
    double value[CLOD_FIELD_COUNT], square[CLOD_FIELD_COUNT], reported[CLOD_FIELD_COUNT];
} trial_means;

/** One of so many trials. */
static inline void trial_means_add(trial_means *self, const clod_locus *locus, int trials)
{
    for (clod_field_index f = CLOD_FIELD_TAU_P; f < CLOD_FIELD_RHO_B; f++) {
        const clod_locus_value value = clod_field_get(locus, f);
        self->value[f] += value.value / trials;
        self->square[f] += value.value * value.value / trials;
        self->reported[f] += value.error * value.error / trials;
    }
}

/** Root mean square of the reported error over the scatter between trials, field by field. */
static inline void trial_means_ratios(const trial_means *self, double ratio[CLOD_FIELD_COUNT])
{
    for (clod_field_index f = CLOD_FIELD_TAU_P; f < CLOD_FIELD_RHO_B; f++) {
        ratio[f] =
            sqrt(self->reported[f] / (self->square[f] - self->value[f] * self->value[f]));
    }
}

/** |a - b| <= relative * |b| */
#define assert_near(a, b, relative)                                                            \
    do {                                                                                       \
        const double near_a = (a);                                                             \
        const double near_b = (b);                                                             \
        if (!(fabs(near_a - near_b) <= (relative)*fabs(near_b))) {                             \
            fail_msg("%s = %.17g, expected %.17g within %g", #a, near_a, near_b,               \
                     (double)(relative));                                                      \
        }                                                                                      \
    } while (0)

#define assert_within(a, low, high)                                                            \
    do {                                                                                       \
        const double within_a = (a);                                                           \
        if (!(within_a >= (low) && within_a <= (high))) {                                      \
            fail_msg("%s = %.17g, expected %g to %g", #a, within_a, (double)(low),             \
                     (double)(high));                                                          \
        }                                                                                      \
    } while (0)

static inline bool has_warning(const clod_locus *locus, const char *part)
{
    for (size_t i = 0; i < locus->warning_count; i++) {
        if (strstr(locus->warnings[i], part) != NULL) {
            return true;
        }
    }
    return false;
}

/** A good test of one preshear: no warning. */
static inline void good_points(clod_locus_point points[4])
{
    const double sigma[] = {3e3, 4.5e3, 6e3, 7.5e3};
    points_on_line(1e3, 35.0 * DEG, 10e3, 7.6e3, sigma, 4, points);
}

/** The locus of points that have one. */
static inline clod_locus evaluate(const clod_locus_point *points, size_t count)
{
    static clod_status status;
    clod_locus locus;
    if (!clod_locus_evaluate(points, count, &locus, &status)) {
        fail_msg("%s", status.text);
    }
    return locus;
}
