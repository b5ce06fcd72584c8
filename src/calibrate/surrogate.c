#include "calibrate/surrogate.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "base/memory.h"
#include "calibrate/surrogate_fit.h"

const char *const CLOD_SURROGATE_NAMES[] = {[CLOD_SURROGATE_LINEAR] = "linear",
                                            [CLOD_SURROGATE_QUADRATIC] = "quadratic",
                                            [CLOD_SURROGATE_GAUSSIAN] = "gaussian process"};

// A result that is the same in all runs still has a variance above 0, far below any digit told.
#define LEAST_RELATIVE 1e-12

size_t clod_surrogate_gaussian_points(size_t dimensions)
{
    return 5 * dimensions > 8 ? 5 * dimensions : 8;
}

clod_surrogate_kind clod_surrogate_choose(size_t dimensions, size_t points)
{
    if (points >= clod_surrogate_gaussian_points(dimensions)) {
        return CLOD_SURROGATE_GAUSSIAN;
    }
    return points >= 2 * clod_surrogate_terms(CLOD_SURROGATE_QUADRATIC, dimensions)
               ? CLOD_SURROGATE_QUADRATIC
               : CLOD_SURROGATE_LINEAR;
}

size_t clod_surrogate_terms(clod_surrogate_kind kind, size_t dimensions)
{
    return kind == CLOD_SURROGATE_QUADRATIC ? (dimensions + 1) * (dimensions + 2) / 2
                                            : dimensions + 1;
}

static bool same_point(const clod_surrogate_runs *runs, size_t a, size_t b)
{
    const double *left = runs->inputs + a * runs->dimensions;
    const double *right = runs->inputs + b * runs->dimensions;
    for (size_t k = 0; k < runs->dimensions; k++) {
        if (left[k] != right[k]) {
            return false;
        }
    }
    return true;
}

/** Whether no earlier run has the point of this one. */
static bool is_first(const clod_surrogate_runs *runs, size_t row)
{
    for (size_t i = 0; i < row; i++) {
        if (same_point(runs, i, row)) {
            return false;
        }
    }
    return true;
}

size_t clod_surrogate_points(const clod_surrogate_runs *runs)
{
    size_t count = 0;
    for (size_t i = 0; i < runs->count; i++) {
        count += is_first(runs, i) ? 1 : 0;
    }
    return count;
}

void clod_surrogate_terms_at(const clod_surrogate *self, const double *u, double *terms)
{
    size_t at = 0;
    terms[at++] = 1.0;
    for (size_t k = 0; k < self->dimensions; k++) {
        terms[at++] = u[k];
    }
    for (size_t k = 0; self->kind == CLOD_SURROGATE_QUADRATIC && k < self->dimensions; k++) {
        for (size_t m = k; m < self->dimensions; m++) {
            terms[at++] = u[k] * u[m];
        }
    }
}

double clod_surrogate_correlation(const clod_surrogate *self, const double *a, const double *b)
{
    if (self->kind != CLOD_SURROGATE_GAUSSIAN) {
        return 0.0;
    }
    double square = 0.0;
    for (size_t k = 0; k < self->dimensions; k++) {
        const double apart = (a[k] - b[k]) / self->hyper.lengths[k];
        square += apart * apart;
    }
    const double r = sqrt(5.0 * square);
    return (1.0 + r + r * r / 3.0) * exp(-r);
}

void clod_surrogate_put_row(const clod_surrogate *self, const double *points, size_t i,
                            double noise, gsl_matrix *v)
{
    const double *u = points + i * self->dimensions;
    gsl_matrix_set(v, i, i, (self->kind == CLOD_SURROGATE_GAUSSIAN ? 1.0 : 0.0) + noise);
    for (size_t j = 0; j < i; j++) {
        const double r = clod_surrogate_correlation(self, u, points + j * self->dimensions);
        gsl_matrix_set(v, i, j, r);
        gsl_matrix_set(v, j, i, r);
    }
}

/** What the packings say beyond their means: of the noise alone. */
typedef struct within {
    double squares;         ///< about the means, over the variance of the noise
    double half_logarithms; ///< half the logarithm of the determinant that the means lack
} within;

/** V: correlation of the places' means over the process variance, noise on its diagonal. */
static within fill_matrix(clod_surrogate *self)
{
    const bool gaussian = self->kind == CLOD_SURROGATE_GAUSSIAN;
    within of = {0.0, 0.0};
    self->mean_growth = 0.0;
    for (size_t i = 0; i < self->place_count; i++) {
        const double *u = self->places + i * self->dimensions;
        const double packings = self->packings[i];
        const double growth = clod_surrogate_growth(self, u);
        const double noise = gaussian ? self->hyper.nugget * growth : growth;
        self->mean_growth += growth * packings / (double)self->count;
        of.squares += self->squares[i] / noise;
        of.half_logarithms += 0.5 * ((packings - 1.0) * log(noise) + log(packings));
        clod_surrogate_put_row(self, self->places, i, noise / packings, self->factor);
        clod_surrogate_terms_at(self, u, gsl_matrix_ptr(self->basis, i, 0));
    }
    return of;
}

/** Sum of the logs of a Cholesky factor's diagonal. */
static double half_log_determinant(const gsl_matrix *factor)
{
    double sum = 0.0;
    for (size_t i = 0; i < factor->size1; i++) {
        sum += log(gsl_matrix_get(factor, i, i));
    }
    return sum;
}

bool clod_surrogate_factor(clod_surrogate *self)
{
    const within packings = fill_matrix(self);
    if (gsl_linalg_cholesky_decomp1(self->factor) != GSL_SUCCESS) {
        return false;
    }
    gsl_blas_dtrsm(CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, 1.0, self->factor,
                   self->basis); // basis becomes L^-1 H
    gsl_vector_const_view means = gsl_vector_const_view_array(self->means, self->place_count);
    gsl_vector_memcpy(self->residual, &means.vector);
    gsl_blas_dtrsv(CblasLower, CblasNoTrans, CblasNonUnit, self->factor, self->residual);
    gsl_blas_dsyrk(CblasLower, CblasTrans, 1.0, self->basis, 0.0, self->normal);
    if (gsl_linalg_cholesky_decomp1(self->normal) != GSL_SUCCESS) {
        return false;
    }
    gsl_blas_dgemv(CblasTrans, 1.0, self->basis, self->residual, 0.0, self->beta);
    gsl_linalg_cholesky_svx(self->normal, self->beta);
    gsl_blas_dgemv(CblasNoTrans, -1.0, self->basis, self->beta, 1.0, self->residual);
    double square = 0.0;
    gsl_blas_ddot(self->residual, self->residual, &square);
    const double freedom = (double)(self->count - self->terms);
    self->variance = fmax((square + packings.squares) / freedom, self->least);
    self->likelihood = clod_surrogate_prior(self) - 0.5 * freedom * log(self->variance) -
                       half_log_determinant(self->factor) - packings.half_logarithms -
                       half_log_determinant(self->normal);
    return isfinite(self->likelihood);
}

/** Means of the packings of each place, and squares about them. */
static void take_places(clod_surrogate *self, const clod_surrogate_runs *runs)
{
    size_t place = 0;
    for (size_t i = 0; i < runs->count; i++) {
        if (!is_first(runs, i)) {
            continue;
        }
        double sum = 0.0, packings = 0.0, squares = 0.0;
        for (size_t k = i; k < runs->count; k++) {
            const bool here = same_point(runs, i, k);
            sum += here ? runs->results[k] : 0.0;
            packings += here ? 1.0 : 0.0;
        }
        const double mean = sum / packings;
        for (size_t k = i; k < runs->count; k++) {
            const double off = runs->results[k] - mean;
            squares += same_point(runs, i, k) ? off * off : 0.0;
        }
        memcpy(self->places + place * runs->dimensions, runs->inputs + i * runs->dimensions,
               runs->dimensions * sizeof(double));
        self->means[place] = mean;
        self->squares[place] = squares;
        self->packings[place++] = packings;
    }
}

/** Room for all arrays, and the runs copied. */
static clod_surrogate *make(const clod_surrogate_runs *runs, clod_surrogate_kind kind)
{
    gsl_set_error_handler_off(); // GSL's own ends the program
    clod_surrogate *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        return NULL;
    }
    const size_t terms = clod_surrogate_terms(kind, runs->dimensions);
    self->dimensions = runs->dimensions;
    self->count = runs->count;
    self->terms = terms;
    self->kind = kind;
    self->inputs = clod_memory_alloc(runs->count * runs->dimensions, sizeof(double));
    self->results = clod_memory_alloc(runs->count, sizeof(double));
    self->place_count = clod_surrogate_points(runs);
    self->places =
        clod_memory_alloc(self->place_count * (runs->dimensions + 3), sizeof(double));
    self->factor = gsl_matrix_alloc(self->place_count, self->place_count);
    self->basis = gsl_matrix_alloc(self->place_count, terms);
    self->normal = gsl_matrix_alloc(terms, terms);
    self->beta = gsl_vector_alloc(terms);
    self->residual = gsl_vector_alloc(self->place_count);
    if (self->inputs == NULL || self->results == NULL || self->places == NULL ||
        self->factor == NULL || self->basis == NULL || self->normal == NULL ||
        self->beta == NULL || self->residual == NULL) {
        clod_surrogate_destroy(&self);
        return NULL;
    }
    memcpy(self->inputs, runs->inputs, runs->count * runs->dimensions * sizeof(double));
    memcpy(self->results, runs->results, runs->count * sizeof(double));
    self->means = self->places + self->place_count * runs->dimensions;
    self->squares = self->means + self->place_count;
    self->packings = self->squares + self->place_count;
    take_places(self, runs);
    double largest = 0.0;
    for (size_t i = 0; i < runs->count; i++) {
        largest = fmax(largest, fabs(runs->results[i]));
    }
    self->least = fmax(LEAST_RELATIVE * LEAST_RELATIVE * largest * largest, 1e-300);
    return self;
}

/** Errors of runs that no surrogate can be made from. */
static bool enough(const clod_surrogate_runs *runs, clod_surrogate_kind kind,
                   clod_status *status)
{
    CLOD_ASSERT(runs->dimensions >= 1 && runs->dimensions <= CLOD_SURROGATE_MOST);
    const size_t terms = clod_surrogate_terms(kind, runs->dimensions);
    return (runs->count > terms && clod_surrogate_points(runs) >= terms) ||
           clod_status_fail(status, CLOD_USAGE,
                            "%zu runs at %zu different points are too few for a surrogate with "
                            "%zu coefficients.",
                            runs->count, clod_surrogate_points(runs), terms);
}

/** A surrogate that is not fitted yet; NULL with a status. */
static clod_surrogate *begin(const clod_surrogate_runs *runs, clod_surrogate_kind kind,
                             clod_status *status)
{
    if (!enough(runs, kind, status)) {
        return NULL;
    }
    clod_surrogate *self = make(runs, kind);
    if (self == NULL) {
        clod_status_fail(status, CLOD_FAILED, "No memory for a surrogate.");
    }
    return self;
}

static clod_surrogate *finish(clod_surrogate *self, bool good, clod_status *status)
{
    if (!good) {
        clod_surrogate_destroy(&self);
        clod_status_fail(status, CLOD_USAGE,
                         "The runs' points do not tell the coefficients of a surrogate apart.");
    }
    return self;
}

clod_surrogate *clod_surrogate_create(const clod_surrogate_runs *runs, clod_surrogate_kind kind,
                                      clod_status *status)
{
    clod_surrogate *self = begin(runs, kind, status);
    if (self == NULL) {
        return NULL;
    }
    const bool good = clod_surrogate_fit(self, runs->stop);
    if (clod_stop_asked(runs->stop)) {
        clod_surrogate_destroy(&self);
        clod_stop_fail(status);
        return NULL;
    }
    return finish(self, good, status);
}

clod_surrogate *clod_surrogate_create_at(const clod_surrogate_runs *runs,
                                         clod_surrogate_kind kind,
                                         const clod_surrogate_hyper *hyper, clod_status *status)
{
    clod_surrogate *self = begin(runs, kind, status);
    if (self == NULL) {
        return NULL;
    }
    self->hyper = *hyper;
    return finish(self, clod_surrogate_factor(self), status);
}

void clod_surrogate_destroy(clod_surrogate **self)
{
    if (self == NULL || *self == NULL) {
        return;
    }
    gsl_matrix_free((*self)->factor);
    gsl_matrix_free((*self)->basis);
    gsl_matrix_free((*self)->normal);
    gsl_vector_free((*self)->beta);
    gsl_vector_free((*self)->residual);
    clod_memory_free((*self)->inputs);
    clod_memory_free((*self)->results);
    clod_memory_free((*self)->places);
    clod_memory_free(*self);
    *self = NULL;
}

size_t clod_surrogate_room(const clod_surrogate *self)
{
    return self->place_count + 2 * self->terms;
}

clod_surrogate_value clod_surrogate_at(const clod_surrogate *self, const double *inputs,
                                       double *room)
{
    const size_t places = self->place_count;
    gsl_vector_view w = gsl_vector_view_array(room, places);
    gsl_vector_view h = gsl_vector_view_array(room + places, self->terms);
    gsl_vector_view t = gsl_vector_view_array(room + places + self->terms, self->terms);
    clod_surrogate_terms_at(self, inputs, h.vector.data);
    double mean;
    gsl_blas_ddot(&h.vector, self->beta, &mean);
    double left = 1.0;
    if (self->kind == CLOD_SURROGATE_GAUSSIAN) {
        for (size_t i = 0; i < places; i++) {
            room[i] =
                clod_surrogate_correlation(self, inputs, self->places + i * self->dimensions);
        }
        gsl_blas_dtrsv(CblasLower, CblasNoTrans, CblasNonUnit, self->factor, &w.vector);
        double part, square;
        gsl_blas_ddot(&w.vector, self->residual, &part);
        gsl_blas_ddot(&w.vector, &w.vector, &square);
        mean += part;
        left = fmax(0.0, 1.0 - square);
        gsl_blas_dgemv(CblasTrans, -1.0, self->basis, &w.vector, 1.0, &h.vector);
    } else { // it may be off as runs are off it on the average, or as they are there if that is more
        left = fmax(self->mean_growth, clod_surrogate_growth(self, inputs));
    }
    gsl_vector_memcpy(&t.vector, &h.vector);
    gsl_blas_dtrsv(CblasLower, CblasNoTrans, CblasNonUnit, self->normal, &t.vector);
    double spread;
    gsl_blas_ddot(&t.vector, &t.vector, &spread);
    return (clod_surrogate_value){mean, self->variance * (left + spread)};
}

double clod_surrogate_likelihood(const clod_surrogate *self)
{
    return self->likelihood;
}

double clod_surrogate_length(const clod_surrogate *self, size_t dimension)
{
    return self->kind == CLOD_SURROGATE_GAUSSIAN ? self->hyper.lengths[dimension]
                                                 : (double)INFINITY;
}

clod_surrogate_kind clod_surrogate_kind_of(const clod_surrogate *self)
{
    return self->kind;
}
