#pragma once
/**
 * @file specimens.h
 * How the specimens of a test differ, as moves of its results that belong together.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/locus.h"
#include "hopper/curve.h"

/** What a yield locus says of a specimen. */
typedef enum clod_specimens_value {
    CLOD_SPECIMENS_SIGMA_1,
    CLOD_SPECIMENS_STRENGTH,
    CLOD_SPECIMENS_PHI_E,
    CLOD_SPECIMENS_PHI_T,
    CLOD_SPECIMENS_RHO,
    CLOD_SPECIMENS_VALUES,
} clod_specimens_value;

/** Moves of the means of all loci of a study. */
typedef struct clod_specimens {
    int64_t *seeds; ///< [count] owned, ascending
    size_t count;   ///< different seeds, over all loci
    double
        *spread; ///< [loci][CLOD_SPECIMENS_VALUES][count] owned; NULL: no locus has two seeds
} clod_specimens;

/**
 * Of n specimens with values v_s and the mean v of one locus, (v_s - v)/sqrt(n (n - 1)): times
 * independent standard normal numbers, one for each specimen, and added up, these have the
 * variances and covariances of the means.
 *
 * @param self  [out] owned content (clod_specimens_fini), also when there is no memory
 * @return      false: no memory
 * Threads  pure.   Source  docs/theory/hopper.md.   Test  tests/hopper/test_specimens.c
 */
bool clod_specimens_of(const clod_locus_study *study, clod_specimens *self);

/** The moves of one value of one locus, [count]. */
const double *clod_specimens_at(const clod_specimens *self, size_t locus,
                                clod_specimens_value value);

/** Free the content; zeros are fine. */
void clod_specimens_fini(clod_specimens *self);

/**
 * Set `set` and `freedom` of points from who is in their spread: points that share a specimen, or a
 * chain of them, are one set, with the degrees of freedom of its point of fewest specimens.
 *
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_specimens.c
 */
void clod_specimens_sort(clod_curve_point *points, size_t count, size_t specimens);

/**
 * What a specimen alone says at a point; NAN where it is not in it.
 *
 * @param spread  [specimens] of the value whose mean is `mean`
 */
double clod_specimens_value_of(double mean, const double *spread, size_t specimens,
                               size_t specimen);
