#pragma once
/**
 * @file saturation.h
 * Fit of Janssen's law in the form of Vanel & Clement: what the floor of a silo carries, over
 * what was filled in.
 */

#include <stddef.h>

/**
 * Apparent mass: saturated (1 - exp(-filled/saturated)).
 *
 * @param filled     mass above [kg]; any unit, the same as of `saturated`
 * @param saturated  > 0
 * Source  H. A. Janssen, Z. VDI 39 (1895) 1045; Vanel & Clement, Eur. Phys. J. B 11 (1999) 525.
 */
double clod_verify_saturation_at(double filled, double saturated);

/**
 * The saturated mass of a law through points, by least squares of the apparent mass.
 *
 * @param filled    [count] > 0; at least one
 * @param apparent  [count] not all above `filled`
 * @return          between 1/1000 and 1000 times the largest `filled`
 * Errors  none.   Threads  pure.   Test  tests/verify/test_saturation.c
 */
double clod_verify_saturation_fit(const double *filled, const double *apparent, size_t count);
