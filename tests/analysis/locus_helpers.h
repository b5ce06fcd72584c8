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
