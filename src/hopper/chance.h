#pragma once
/**
 * @file chance.h
 * How often chance alone makes points lie so far off a line.
 */

#include <stddef.h>

/**
 * Chance of a chi-square, or a larger one: of `freedom` degrees of freedom; or, where the errors themselves are
 * estimates of `errors` degrees of freedom, of Fisher's F, chi_square/freedom.
 *
 * @param freedom  1 at least
 * @param errors   0: the errors are known
 * Errors  none.   Threads  pure.
 * Source  NIST Digital Library of Mathematical Functions, 8.11 and 8.17.22.   Test  tests/hopper/test_line_fit.c
 */
double clod_chance_above(double chi_square, size_t freedom, size_t errors);
