#pragma once
/**
 * @file surrogate_fit.h
 * What a surrogate is made of, for surrogate.c, surrogate_fit.c and surrogate_out.c alone.
 */

#include <gsl/gsl_matrix.h>
#include <gsl/gsl_vector.h>

#include "calibrate/surrogate.h"

/** With V = L L' the correlation of results, H the polynomial's terms at the runs. */
struct clod_surrogate {
    size_t dimensions, count, terms;
    clod_surrogate_kind kind;
    double *inputs, *results; ///< [count][dimensions], [count] owned
    double lengths[CLOD_SURROGATE_MOST];
    double nugget;        ///< variance of the noise of packings over that of the process
    double variance;      ///< of the process; of the noise in a polynomial
    double least;         ///< that the variance is kept above
    double likelihood;    ///< restricted, logarithm, without constants
    gsl_matrix *factor;   ///< L
    gsl_matrix *basis;    ///< L^-1 H
    gsl_matrix *normal;   ///< Cholesky factor of H' V^-1 H
    gsl_vector *beta;     ///< coefficients by generalised least squares
    gsl_vector *residual; ///< L^-1 (results - H beta)
};

/** Factor all at the present lengths and nugget; false when a matrix is singular. */
bool clod_surrogate_factor(clod_surrogate *self);

/** Matern 5/2 correlation of two points; 0 for a polynomial. */
double clod_surrogate_correlation(const clod_surrogate *self, const double *a, const double *b);

/** Find lengths and nugget of greatest restricted likelihood, and factor there; false also when `stop` was
 *  asked for, by then or before every likelihood. */
bool clod_surrogate_fit(clod_surrogate *self, const clod_stop *stop);
