/**
 * @file surrogate_residuals.c
 * What single runs are off a surrogate, whose matrices are those of places.
 */

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

#include "calibrate/surrogate_fit.h"

/** Correlation of the results of all runs over the process variance, noise on its diagonal. */
static void fill(const clod_surrogate *self, gsl_matrix *v)
{
    const double nugget = self->kind == CLOD_SURROGATE_GAUSSIAN ? self->hyper.nugget : 1.0;
    for (size_t i = 0; i < self->count; i++) {
        const double growth = clod_surrogate_growth(self, self->inputs + i * self->dimensions);
        clod_surrogate_put_row(self, self->inputs, i, nugget * growth, v);
    }
}

/** What a run is off the polynomial with its coefficients. */
static double off(const clod_surrogate *self, size_t i, gsl_vector *terms)
{
    double told;
    clod_surrogate_terms_at(self, self->inputs + i * self->dimensions, terms->data);
    gsl_blas_ddot(terms, self->beta, &told);
    return self->results[i] - told;
}

bool clod_surrogate_residuals(const clod_surrogate *self, double *residuals)
{
    gsl_matrix *v = gsl_matrix_alloc(self->count, self->count);
    gsl_vector *terms = gsl_vector_alloc(self->terms);
    bool good = v != NULL && terms != NULL;
    if (good) {
        gsl_vector_view left = gsl_vector_view_array(residuals, self->count);
        fill(self, v);
        for (size_t i = 0; i < self->count; i++) {
            residuals[i] = off(self, i, terms);
        }
        good = gsl_linalg_cholesky_decomp1(v) == GSL_SUCCESS; // that of the places could be
        gsl_blas_dtrsv(CblasLower, CblasNoTrans, CblasNonUnit, v, &left.vector);
    }
    gsl_matrix_free(v);
    gsl_vector_free(terms);
    return good;
}
