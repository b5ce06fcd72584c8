#pragma once
/**
 * @file draw.h
 * A solid as it may be, drawn from what was measured and its errors.
 */

#include <stdint.h>

#include "hopper/solid.h"

/** Room for what one sample draws. */
typedef struct clod_draw {
    const clod_solid *measured;
    uint64_t seed;
    double *numbers; ///< owned: for each test one of each specimen, then one scale of each set
    size_t specimens[CLOD_CURVE_TESTS], sets[CLOD_CURVE_TESTS];
} clod_draw;

/** Begin; false: no memory. `measured` is borrowed. */
bool clod_draw_init(clod_draw *self, const clod_solid *measured, uint64_t seed);

void clod_draw_fini(clod_draw *self);

/**
 * Draw every point of every curve; stresses stay positive, angles below a right one.
 *
 * Errors of a point are normal. What its specimens share is one standard normal number for each
 * specimen, at all its points and in all its values, and sqrt(n/chi-square of n) for each set of
 * specimens, n its degrees of freedom: Student's t, since the scatter of few specimens is hardly
 * known.
 *
 * @param item  number of the sample
 * @param to    curves of as many points as measured
 * Errors  none.   Threads  one room for each.
 * Source  docs/theory/hopper.md.   Test  tests/hopper/test_draw.c, test_interval.c
 */
void clod_draw_solid(clod_draw *self, uint64_t item, clod_solid *to);

/** Draw a limit of mass flow [rad] that was given with a normal error.   Threads  one room for each. */
double clod_draw_limit(const clod_draw *self, uint64_t item, double limit, double error);
