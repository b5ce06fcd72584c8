#pragma once
/**
 * @file spread.h
 * Values of a yield locus from its points, and how errors of the points carry over to them.
 */

#include "analysis/fields.h"
#include "analysis/fit.h"
#include "analysis/mohr.h"

/** Everything that follows from a set of points. */
typedef struct clod_spread_result {
    double field[CLOD_FIELD_COUNT]; ///< in the order of CLOD_FIELDS; densities stay 0
    double sigma_c;                 ///< also of negative cohesion, unlike the field
    clod_fit fit;
    clod_mohr steady;
} clod_spread_result;

/**
 * Evaluate points by the equations of docs/theory/yield-locus.md.
 *
 * @param points    [count]
 * @param sigma     [count] [out] normal stresses
 * @param prorated  [count] [out] prorated shear stresses
 */
clod_spread_result clod_spread_evaluate(const clod_locus_point *points, size_t count,
                                        double *sigma, double *prorated);

/**
 * Relative standard deviation between the preshears of one seed beyond their stated errors; 0: there is one preshear.
 * Preshears of one specimen differ by less than specimens do.
 *
 * @param points  [count]
 * @param first   [count] of clod_preshear_find
 * @param tau_p   mean over the points
 * Errors  none.   Threads  pure.   Test  tests/analysis/test_locus_preshear.c, calibrate/test_plan_shear.c
 */
double clod_spread_preshears(const clod_locus_point *points, const size_t *first, size_t count,
                             double tau_p);

/** Errors of the fields, and how they go together. */
typedef struct clod_spread_told {
    double error[CLOD_FIELD_COUNT];       ///< 0 for sigma_p and densities
    double correlation[CLOD_LOCUS_PAIRS]; ///< 0 where one of the two has no error
} clod_spread_told;

/**
 * Standard errors of the fields, and their correlations, by propagation. The causes are independent of each other:
 *
 * - of each point, what was stated for tau_s,
 * - of each preshear, what was stated for tau_p, for all of its points together,
 * - of each preshear, what preshears differ by: scatter of tau_p between them beyond
 *   the stated errors, taken to act on tau_p and tau_s of its points by the same factor, as
 *   prorating supposes,
 * - of each point, what the points scatter about the line beyond all that, taken to be in
 * tau_s.
 *
 * Every cause is carried over by evaluating the points at plus and minus one of it. Without
 * stated errors the last one is the usual covariance of a regression.
 *
 * @param points   [count]
 * @param first    [count] which points share a preshear, of clod_preshear_find
 * @param best     of the points as they are
 * @param scratch  [2 * count] overwritten
 * @param changed  [count] overwritten
 * @param told     [out]
 * Errors  none.   Threads  pure.
 * Test    tests/analysis/test_locus_errors.c, test_locus_preshear.c
 */
void clod_spread_errors(const clod_locus_point *points, const size_t *first, size_t count,
                        const clod_spread_result *best, double *scratch,
                        clod_locus_point *changed, clod_spread_told *told);
