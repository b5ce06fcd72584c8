#pragma once
/**
 * @file line_fit.h
 * How the points of a line weigh, and how well it fits them.
 */

#include "hopper/curve.h"

#define CLOD_LINE_FIT_RARE 0.05 ///< chance below which a line does not fit its points

/** Standard error of a point across a line of this slope: of y - slope x. Threads  pure. */
double clod_line_fit_error(const clod_curve *curve, const clod_curve_point *point,
                           double slope);

/**
 * Weigh the points of a line by their errors, in y and across the line, and compare what is left with them.
 * Errors that are the scatter of specimens, or of the points about a line, or come of a yield locus, do not weigh: they are hardly known. Where the points lie further off than
 * their errors, `stretch` is sqrt(chi_square/freedom); where specimens tell the errors, only if that is no chance.
 *
 * @param curve  [in, out] weights of its points and misfit; another way than a line is left as it is
 * Errors  none.   Threads  pure.
 * Source  J. Orear, Am. J. Phys. 50 (1982) 912 (effective variance); Particle Data Group, Prog. Theor. Exp. Phys. 2022,
 *         083C01, Introduction, 5.2.2 (scale factor); docs/theory/hopper.md.
 * Test    tests/hopper/test_line_fit.c
 */
void clod_line_fit_weigh(clod_curve *curve);

/** Whether a line misses its points by more than their errors tell.   Threads  pure. */
bool clod_line_fit_misses(const clod_curve_misfit *self);
