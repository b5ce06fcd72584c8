#pragma once
/**
 * @file preshear.h
 * Which points stem from one preshear and share its measurement, with its one error.
 */

#include <stddef.h>

#include "clod/locus.h"

/**
 * Find the preshear of every point.
 *
 * All points of one seed and one sigma_p stem from one preshear when tau_p, rho_b and the
 * errors of both are equal in all of them to the last digit, and rho_inside where it is told, as a simulation that branches off
 * one sheared specimen writes them. As soon as one of them differs, each of these points had a
 * preshear of its own: so points of the laboratory that agree by chance of rounding stay apart.
 *
 * @param points  [count]
 * @param first   [count] [out] index of the first point of the same preshear
 * Errors  none.   Threads  pure.   Source  docs/theory/yield-locus.md.
 * Test    tests/analysis/test_locus_preshear.c
 */
void clod_preshear_find(const clod_locus_point *points, size_t count, size_t *first);
