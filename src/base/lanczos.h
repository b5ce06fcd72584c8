#pragma once
/**
 * @file lanczos.h
 * Largest eigenvalue of a large symmetric matrix that is known by its products only.
 */

#include <stdbool.h>
#include <stddef.h>

/** y = A x of a symmetric matrix A. @param x, y  [size] */
typedef void (*clod_lanczos_product)(const void *matrix, const double *x, double *y);

/** Room for four vectors of the matrix's size. */
typedef struct clod_lanczos {
    size_t size;
    double *start;   ///< [size] of any length; set by the caller, kept
    double *now;     ///< [size] scratch, as the next two
    double *before;  ///< [size]
    double *product; ///< [size]
} clod_lanczos;

/** @return  false without memory; clod_lanczos_fini, also then */
bool clod_lanczos_init(clod_lanczos *self, size_t size);

/**
 * The largest eigenvalue whose vector the start has a part of, from below: to 1e-6 of it where it
 * stands apart from the others, to 2e-5 at the end of a band.
 *
 * Every sum has one order, so the same start gives the same bits.
 *
 * @param self     with a start
 * @param matrix   symmetric, no eigenvalue below 0
 * @param product  its products
 * @return         0 for a matrix or a start of zeros; no number when a product is none
 * Errors  none.   Threads  one per self.
 * Source  Lanczos 1950 without reorthogonalisation (Paige 1972: the largest one stays right);
 *         Sturm's count for the tridiagonal matrix (Golub & Van Loan, sec. 8.4).
 * Test    tests/base/test_lanczos.c
 */
double clod_lanczos_largest(clod_lanczos *self, const void *matrix,
                            clod_lanczos_product product);

void clod_lanczos_fini(clod_lanczos *self);
