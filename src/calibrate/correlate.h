#pragma once
/**
 * @file correlate.h
 * How numbers of one test move together: correlations from few residuals. docs/theory/calibration.md
 * has the equations.
 */

#include <stddef.h>

/** Residuals of several numbers about their means or fits. */
typedef struct clod_correlate_rows {
    const double *values; ///< [rows][count]; NAN: not there
    size_t rows, count;
    size_t block; ///< rows that were centred together: a mean is lost in each
    size_t lost;  ///< coefficients that were fitted to all rows together, 0 for means alone
} clod_correlate_rows;

/**
 * Correlations over the rows that both numbers have.
 *
 * @param r  [out] [count][count], symmetric, 1 on the diagonal; NAN where no rows tell a pair, if they tell
 *           another
 * @return   degrees of freedom of the told pair with the fewest; 0: no pair is told, and r is 1
 * Errors  none.   Threads  pure.   Test  tests/calibrate/test_correlate.c
 */
double clod_correlate(const clod_correlate_rows *self, double *r);

/** Give pairs that are not told their correlations of `other`, or, without it (NULL), the mean of those that are
 *  told, not below 0. */
void clod_correlate_complete(double *r, const double *other, size_t count);

/** Make r the mean of it, with `degrees`, and another, with `more`. @return sum of both */
double clod_correlate_join(double *r, double degrees, const double *other, double more,
                           size_t count);

/**
 * Draw correlations towards equal ones: (nu r + count c)/(nu + count), with c between all numbers the
 * mean of r, not below 0, times nu/(nu + 1). It is positive definite, and of numbers that
 * move together it keeps that they do.
 *
 * @param degrees  nu, of r; 0: it becomes 1
 * Errors  none.   Threads  pure.
 * Source  Ledoit and Wolf, J. Portfolio Management 30(4) (2004) 110, with the weight given.
 * Test    tests/calibrate/test_correlate.c
 */
void clod_correlate_shrink(double *r, size_t count, double degrees);

/** Of variances of `count` numbers, each with `degrees`, pooled: Satterthwaite's, between `degrees` of
 *  numbers that are one and count times as many of independent ones. */
double clod_correlate_pooled(const double *r, size_t count, double degrees);

/**
 * L of v = L L', in its lower half, in place.
 * @return log of the determinant of v; NAN: it is not positive definite
 */
double clod_correlate_factor(double *v, size_t count);

/** Square of L^-1 x, the distance of x; x is used up. */
double clod_correlate_distance(const double *factor, size_t count, double *x);
