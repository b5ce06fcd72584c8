#pragma once
/**
 * @file sobol.h
 * Points of a design of experiments: a Sobol sequence in the unit cube.
 */

#include <stdbool.h>
#include <stddef.h>

#define CLOD_SOBOL_MOST 16 ///< dimensions; GSL's sequence has 40

/**
 * The first points of the sequence, without the origin: the first is the middle of the cube. The first
 * 2^m - 1 points and the origin have one coordinate in every interval of length 2^-m.
 *
 * @param dimensions  1 to CLOD_SOBOL_MOST
 * @param points      [out] [count][dimensions], inside (0, 1)
 * Errors  false: no memory.   Threads  safe.
 * Source  Antonov and Saleev, USSR Comput. Maths. Math. Phys. 19 (1980), as in GSL.
 * Test    tests/calibrate/test_sobol.c
 */
bool clod_sobol_fill(size_t dimensions, size_t count, double *points);
