#pragma once
/**
 * @file scatter.h
 * What the points of a curve scatter by about their line, as the error of those that state none.
 */

#include "hopper/curve.h"

/**
 * Where points state no error of y, they and those that state a smaller one get the standard deviation of all points about
 * their line, sqrt(residual/(n - 2)), of n - 2 degrees of freedom and one scale. Two points tell none, nor do points on a
 * line by construction: they keep none. Errors below 1e-9 of the largest y are round-off, and none either.
 *
 * @param curve  [in, out] its points' `set` is told
 * @return       false: no memory
 * Errors  none.   Threads  pure.   Source  docs/theory/hopper.md.   Test  tests/hopper/test_wall.c, test_strength.py
 */
bool clod_scatter_take(clod_curve *curve);
