#pragma once
/**
 * @file surrogate_fit.h
 * What a surrogate is made of, for the files surrogate*.c alone.
 */

#include <gsl/gsl_matrix.h>
#include <gsl/gsl_vector.h>

#include "calibrate/surrogate.h"

/** Standard deviation of what the log variance of the noise changes by from a corner of all ranges to the
 *  opposite one, before runs are seen: noise in proportion to a number that doubles is 2 ln 2 = 1.4. */
#define CLOD_SURROGATE_GROWTH 1.5

/**
 * With V = L L' the correlation of the means of places, H the polynomial's terms there. Runs of one place, its
 * packings, are as good as their mean and the squares about it, so that matrices have the size of the places.
 */
struct clod_surrogate {
    size_t dimensions, count, terms;
    clod_surrogate_kind kind;
    double *inputs, *results; ///< [count][dimensions], [count] owned: the runs
    size_t place_count;
    double *
        places; ///< [place_count][dimensions] owned, in the order of their first runs; behind them:
    double *means;    ///< [place_count] of the packings' results
    double *squares;  ///< [place_count] sum of their squares about the mean
    double *packings; ///< [place_count] how many
    clod_surrogate_hyper hyper;
    double mean_growth;   ///< of the noise's variance since the middle, over the runs
    double variance;      ///< of the process; of the noise in the middle in a polynomial
    double least;         ///< that the variance is kept above
    double likelihood;    ///< restricted, with the prior, logarithm, without constants
    gsl_matrix *factor;   ///< L
    gsl_matrix *basis;    ///< L^-1 H
    gsl_matrix *normal;   ///< Cholesky factor of H' V^-1 H
    gsl_vector *beta;     ///< coefficients by generalised least squares
    gsl_vector *residual; ///< L^-1 (means - H beta)
};

#define CLOD_SURROGATE_NUMBERS (2 * CLOD_SURROGATE_MOST + 1)

/** Ranges of what is fitted: logarithms of lengths and nugget, and slopes, in this order. */
typedef struct clod_surrogate_bounds {
    size_t count;
    double low[CLOD_SURROGATE_NUMBERS], high[CLOD_SURROGATE_NUMBERS];
} clod_surrogate_bounds;

/** None of a polynomial whose runs do not tell the slopes. */
void clod_surrogate_bounds_of(const clod_surrogate *self, clod_surrogate_bounds *bounds);

/** These numbers into the hyperparameters, and out of them. */
void clod_surrogate_put(clod_surrogate *self, const double *numbers);
void clod_surrogate_get(const clod_surrogate *self, double *numbers);

/** The same runs with the same hyperparameters. @return owned, or NULL */
clod_surrogate *clod_surrogate_copy(const clod_surrogate *self, clod_status *status);

/** Factor all at the present lengths, nugget and slopes; false when a matrix is singular. */
bool clod_surrogate_factor(clod_surrogate *self);

/** The polynomial's terms at a point. */
void clod_surrogate_terms_at(const clod_surrogate *self, const double *u, double *terms);

/** Matern 5/2 correlation of two points; 0 for a polynomial. */
double clod_surrogate_correlation(const clod_surrogate *self, const double *a, const double *b);

/** Row and column i of V up to the diagonal: correlations of the points, and the noise of this one's result. */
void clod_surrogate_put_row(const clod_surrogate *self, const double *points, size_t i,
                            double noise, gsl_matrix *v);

/** Variance of the noise of packings at a place over that in the middle of all ranges. */
double clod_surrogate_growth(const clod_surrogate *self, const double *inputs);

/** Log prior of the slopes, without constants: from a corner of all ranges to the opposite one the logarithm
 *  of the noise's variance changes by a normal number, whose deviation docs/theory/calibration.md derives. */
double clod_surrogate_prior(const clod_surrogate *self);

/** Find lengths, nugget and slopes of greatest restricted likelihood, and factor there; false also when `stop` was
 *  asked for, by then or before every likelihood. */
bool clod_surrogate_fit(clod_surrogate *self, const clod_stop *stop);
