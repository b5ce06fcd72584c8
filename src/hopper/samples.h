#pragma once
/**
 * @file samples.h
 * How the samples of a design lie, and which measurement makes them differ.
 */

#include <stddef.h>

#include "hopper/solid.h"

/** Value at a share (0 to 1) of the sorted ones, straight between neighbours. Threads  pure. */
double clod_samples_quantile(const double *sorted, size_t count, double share);

/**
 * Standard error of that value if the sorted ones are independent draws: half the distance of the values one standard
 * deviation, sqrt(share (1 - share)/count), of the share to either side. Infinite ones make it infinite, or NAN.
 *
 * Threads  pure.   Source  H. A. David and H. N. Nagaraja, Order Statistics (2003), 2.5 and 7.1.
 * Test     tests/hopper/test_samples.c
 */
double clod_samples_quantile_error(const double *sorted, size_t count, double share);

/**
 * The measured curves at one state. To first order in the errors a critical outlet depends on each
 * curve by this one value: where the flow function meets the flow factor, its value there moves the
 * meeting point, its slope only the change of that.
 *
 * @param value  [out] by their place in clod_solid; the wall's at the state's sigma_w
 * Errors  none.   Threads  pure.
 */
void clod_samples_values(const clod_solid *solid, const clod_solid_state *state,
                         double value[CLOD_SOLID_CURVES]);

/** A value and its place, for sorting. */
typedef struct clod_samples_item {
    double value;
    size_t at;
} clod_samples_item;

/**
 * How much of the spread of outlets each curve tells alone: the square of Spearman's correlation of
 * its drawn values with the outlets, which is that of their ranks. Ranks do not care how far off the
 * wildest samples are, and an infinite outlet is one like others.
 *
 * @param column  [count] each, values of one curve, overwritten; NULL: of no interest
 * @param outlet  [count] m, overwritten; each a number or infinite
 * @param room    [count]
 * @param share   [out] NAN: no column, one drawn without errors, fewer than three outlets, or all the same
 * @return        share that no curve alone tells: 1 less the coefficient of determination of the
 *                outlets' ranks by those of all curves, least squares; NAN as above
 * Errors  none.   Threads  pure.
 * Source  Iman and Conover, Technometrics 21 (1979) 499: regression of ranks; Saltelli et al.,
 *         Sensitivity Analysis (2000), ch. 6; docs/theory/hopper.md
 * Test    tests/hopper/test_samples.c
 */
double clod_samples_shares(double *const column[CLOD_SOLID_CURVES], double *outlet,
                           size_t count, clod_samples_item *room,
                           double share[CLOD_SOLID_CURVES]);
