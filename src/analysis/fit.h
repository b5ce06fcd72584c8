#pragma once
/**
 * @file fit.h
 * Straight line by least squares, and whether the points bend away from it.
 */

#include <stdbool.h>
#include <stddef.h>

/** y = intercept + slope x. */
typedef struct clod_fit {
    double intercept, slope;
    double mean_x, sxx; ///< mean of x and sum of (x - mean)^2
    double residual;    ///< sum of squares about the line
    double r_squared;   ///< 1 when all y are equal and on the line
} clod_fit;

/**
 * Fit a line.
 *
 * @param x  [count] not all equal
 * @param y  [count]
 * Errors  none.   Threads  pure.   Test  tests/analysis/test_locus.c
 */
clod_fit clod_fit_line(const double *x, const double *y, size_t count);

/** Standard error of the slope, from the scatter about the line; `count` > 2. Test: test_fit.c
 */
double clod_fit_slope_error(const clod_fit *line, size_t count);

/** Standard errors of a line; NAN where nothing tells them. */
typedef struct clod_fit_error {
    double slope, intercept;
    bool known; ///< by what is stated for every point, or by the scatter of more than two
} clod_fit_error;

/**
 * Errors by propagation: of each point what is stated for it, and what the points scatter about the
 * line beyond that.
 *
 * @param x         [count] as the line was fitted
 * @param variance  [count] stated for y at each point; 0: none
 * Threads  pure.   Test  tests/analysis/test_fit.c
 */
clod_fit_error clod_fit_errors(const clod_fit *line, const double *x, const double *variance,
                               size_t count);

/**
 * How far a parabola through the points stands off the line: the middle against the ends.
 *
 * @param error  [out] half width of the 95 % interval, from the scatter about the parabola;
 *               INFINITY with fewer than four points
 * @return       sag, same unit as y; positive when the ends lie below the line
 */
double clod_fit_sag(const clod_fit *line, const double *x, const double *y, size_t count,
                    double *error);
