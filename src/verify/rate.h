#pragma once
/**
 * @file rate.h
 * Rate of a steady discharge with its scatter, and the exponent in
 * W = C rho_b sqrt(g) (D - k d)^n.
 */

#include <stddef.h>

#define CLOD_VERIFY_BLOCKS 8
#define CLOD_VERIFY_RATES 16 ///< orifices at most

/** Rate of one orifice. */
typedef struct clod_verify_rate {
    double orifice;      ///< D/d
    double value, error; ///< kg/s, and its standard error
} clod_verify_rate;

/**
 * Slope of discharged mass over time by least squares; its error from the scatter of the rates
 * of CLOD_VERIFY_BLOCKS equal blocks of time.
 *
 * @param time   [count] s, rising evenly; count > CLOD_VERIFY_BLOCKS
 * @param mass   [count] kg
 * @param error  [out] standard error of the mean of the blocks [kg/s]
 * @return       kg/s
 * Errors  none.   Threads  pure.   Test  tests/verify/test_rate.c
 */
double clod_verify_rate_of(const double *time, const double *mass, size_t count, double *error);

/**
 * Exponent n, by a line through ln W over ln(D/d - k).
 *
 * @param rates  [count] three to CLOD_VERIFY_RATES
 * @param error  [out] standard error: from the scatter about the line, or from the errors of
 *               the rates, whichever is larger
 * Errors  none.   Threads  pure.   Test  tests/verify/test_rate.c
 */
double clod_verify_rate_exponent(const clod_verify_rate *rates, size_t count, double k,
                                 double *error);
