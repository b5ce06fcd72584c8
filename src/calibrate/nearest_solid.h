#pragma once
/**
 * @file nearest_solid.h
 * The solid that is nearest to measured numbers of a shear test, among all that are possible.
 */

#include <stdbool.h>
#include <stddef.h>

/** A number of a yield locus, measured; SI. */
typedef struct clod_nearest_number {
    const char
        *key;      ///< c, phi_lin, tau, tau_p, phi_sf, phi_e, sigma_1, sigma_2, sigma_c or ffc
    double stress; ///< normal stress of tau [Pa]
    double value, error; ///< error > 0
    double nearest;      ///< [out] that of the nearest solid
} clod_nearest_number;

/** How far the nearest solid is from the numbers. */
typedef struct clod_nearest {
    double chi_square; ///< least sum of squares, each difference over its error
    double freedom;    ///< degrees: numbers less the unknowns that the fit was free to choose
} clod_nearest;

/** Whether it is a key of clod_nearest_number.   Threads  pure. */
bool clod_nearest_has(const char *key);

/**
 * The nearest solid: a straight yield locus with a cohesion of 0 or more and an angle of 0 to 80 deg, and a circle of
 * steady flow through preshear that touches the locus at a normal stress of 0 or more, or, where preshear is above it by up to a
 * quarter (scatter), its parallel through preshear; phi_sf is 80 deg at most. Where one of the numbers is phi_e the circle has no
 * tension. Unknowns are phi_lin, tau_p and c.
 *
 * @param preshear  stress of preshear, > 0 [Pa]
 * @param numbers   [count] `nearest` is set
 * Errors  chi_square is NAN: no memory.   Threads  pure; the same numbers give the same bits.
 * Source  docs/theory/calibration.md; yield-locus.md, equations 2 to 7.
 * Test    tests/calibrate/test_nearest_solid.c
 */
clod_nearest clod_nearest_fit(double preshear, clod_nearest_number *numbers, size_t count);

/**
 * The chi-square that one in 22 sets of numbers of a possible solid exceeds (two standard errors of a normal number).
 *
 * @param freedom  degrees; below 1 counts as 1
 * Errors  none.   Threads  pure.   Test  tests/calibrate/test_nearest_solid.c
 */
double clod_nearest_limit(double freedom);
