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
 * The measured curves at one state. To first order in the errors a critical outlet depends on each
 * curve by this one value: where the flow function meets the flow factor, its value there moves the
 * meeting point, its slope only the change of that.
 *
 * @param value  [out] by their place in clod_solid; the wall's at the state's sigma_w
 * Errors  none.   Threads  pure.
 */
void clod_samples_values(const clod_solid *solid, const clod_solid_state *state,
                         double value[CLOD_SOLID_CURVES]);

/**
 * Share of the variance of outlets that a straight line over drawn values explains: the square of
 * their correlation. Curves are drawn independently, so their shares add up to 1 where errors are
 * small; what is missing is of higher order.
 *
 * @param drawn   [count] values of one curve
 * @param outlet  [count] m; samples without a finite one are left out
 * @return  0: the curve was drawn without errors; NAN: fewer than three outlets, or all the same
 * Errors  none.   Threads  pure.
 * Source  Saltelli et al., Sensitivity Analysis (2000), ch. 6: squared correlation coefficients of
 *         independent inputs
 * Test    tests/hopper/test_samples.c
 */
double clod_samples_share(const double *drawn, const double *outlet, size_t count);
