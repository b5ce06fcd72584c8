#pragma once
/**
 * @file surrogate.h
 * A result of a simulation as a smooth function of its parameters, from runs with the noise of
 * packings: a Gaussian process about a straight line, or a polynomial where there are few runs. The noise
 * may grow over the ranges.
 * docs/theory/calibration.md has the equations.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "calibrate/stop.h"
#include "clod/status.h"

#define CLOD_SURROGATE_MOST 15 ///< parameters

typedef enum clod_surrogate_kind {
    CLOD_SURROGATE_LINEAR,    ///< least squares on 1, u
    CLOD_SURROGATE_QUADRATIC, ///< least squares on 1, u, products of two
    CLOD_SURROGATE_GAUSSIAN,  ///< Gaussian process about 1, u
} clod_surrogate_kind;

/** What a kind is called: "linear", "quadratic", "gaussian process". */
extern const char *const CLOD_SURROGATE_NAMES[];

/** Runs: rows with the same inputs are packings of one point. */
typedef struct clod_surrogate_runs {
    size_t dimensions, count;
    const double *inputs;  ///< [count][dimensions], in [0, 1]
    const double *results; ///< [count]
    const clod_stop *stop; ///< asked while a surrogate is fitted to them; NULL: never
} clod_surrogate_runs;

/** What a likelihood is of: the noise of packings has the variance nugget exp(slopes . (u - 1/2)) over that of
 *  the process, and exp(slopes . (u - 1/2)) over that in the middle in a polynomial. */
typedef struct clod_surrogate_hyper {
    double lengths
        [CLOD_SURROGATE_MOST]; ///< correlation lengths; not used by a polynomial, nor is the next
    double nugget;             ///< in the middle of all ranges
    double
        slopes[CLOD_SURROGATE_MOST]; ///< of the logarithm of the noise's variance, over a range
} clod_surrogate_hyper;

/** A fitted surrogate; opaque. */
typedef struct clod_surrogate clod_surrogate;

typedef struct clod_surrogate_value {
    double mean; ///< of packings
    /** Of that mean, from what the runs cannot tell. Noise of packings is not in it, but for a
     * polynomial: nothing tells its misfit from that noise, so all counts as misfit. */
    double variance;
} clod_surrogate_value;

/** Leave one point out: how well the others predict it. */
typedef struct clod_surrogate_check {
    size_t points;
    double error;   ///< root of the mean square error of a point's mean
    double q2;      ///< 1 - square errors over squares about the mean; 1: exact
    double scatter; ///< root of the mean square of the points' means about the mean of all
    double covered; ///< share of the points within two standard deviations of their prediction
} clod_surrogate_check;

/** The kind for so many different points: a Gaussian process from 5 a parameter and 8 in all on, a
 *  quadratic from twice its coefficients on. */
clod_surrogate_kind clod_surrogate_choose(size_t dimensions, size_t points);

/** Different points from which on that is a Gaussian process. */
size_t clod_surrogate_gaussian_points(size_t dimensions);

/** Coefficients of the polynomial of a kind. */
size_t clod_surrogate_terms(clod_surrogate_kind kind, size_t dimensions);

/** Different points among runs. */
size_t clod_surrogate_points(const clod_surrogate_runs *runs);

/**
 * Fit by greatest restricted likelihood, with a normal prior of the slopes of the noise about 0. They are 0
 * where so few runs are left over that they tell no more numbers than those of the variance, 1 + dimensions.
 *
 * @param runs  copied
 * @return      owned (clod_surrogate_destroy), or NULL
 * Errors  CLOD_USAGE: fewer runs than coefficients + 1, or points that do not tell them apart; CLOD_FAILED:
 *         memory; CLOD_INTERRUPTED.
 * Threads safe.
 * Source  Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), eq. 2.41 to 2.45,
 *         4.17; Santner, Williams and Notz, The Design and Analysis of Computer Experiments (2003), 3.3.
 * Test    tests/calibrate/test_surrogate.c
 */
clod_surrogate *clod_surrogate_create(const clod_surrogate_runs *runs, clod_surrogate_kind kind,
                                      clod_status *status);

/** The same with lengths, nugget and slopes given, for tests and for points that are left out. */
clod_surrogate *clod_surrogate_create_at(const clod_surrogate_runs *runs,
                                         clod_surrogate_kind kind,
                                         const clod_surrogate_hyper *hyper,
                                         clod_status *status);

/** Random numbers: this stream and the next. */
typedef struct clod_surrogate_dice {
    uint64_t seed, stream;
} clod_surrogate_dice;

/**
 * Surrogates of the same runs whose hyperparameters and variance are drawn from their posterior: lengths and nugget
 * flat in their logarithms within the ranges of the search, slopes by their prior, the variance flat in its logarithm.
 *
 * @param draws      [out] [count] owned by the caller, each; NULL behind the first error
 * @param effective  [out] independent draws that would tell the least known mean of a hyperparameter as well, as far as
 *                   the chain came about; count without hyperparameters, 0 where the chain never moved
 * Errors  CLOD_FAILED: memory; CLOD_INTERRUPTED.   Threads  safe.
 * Source  Handcock and Stein, Technometrics 35 (1993) 403; Gelman et al., Bayesian Data Analysis (2013), 3.2.
 * Test    tests/calibrate/test_surrogate_draws.c
 */
bool clod_surrogate_draw(const clod_surrogate *self, const clod_surrogate_dice *dice,
                         size_t count, const clod_stop *stop, clod_surrogate **draws,
                         double *effective, clod_status *status);

/** Free and null; NULL is fine. */
void clod_surrogate_destroy(clod_surrogate **self);

/** @param room [clod_surrogate_room] numbers of the caller's.  Threads  one per room. */
clod_surrogate_value clod_surrogate_at(const clod_surrogate *self, const double *inputs,
                                       double *room);
size_t clod_surrogate_room(const clod_surrogate *self);

/** Standard deviation between packings of one point. @param inputs [dimensions] the point */
double clod_surrogate_noise(const clod_surrogate *self, const double *inputs);

/** Its least and greatest over all ranges: at two opposite corners, for its logarithm is linear. */
void clod_surrogate_noise_ends(const clod_surrogate *self, double *least, double *greatest);

/** Standard deviation between packings at the point of run number i. */
double clod_surrogate_noise_of(const clod_surrogate *self, size_t i);

/** Growth of the logarithm of the noise's variance over the range of an input. */
double clod_surrogate_slope(const clod_surrogate *self, size_t dimension);

/**
 * What each run is off the fit, L^-1 (results - H b) with L of the runs: independent, with one variance, where
 * the surrogate holds; of a polynomial the residuals over the noise's growth since the middle.
 *
 * @param residuals  [out] [runs]
 * @return  false without memory
 */
bool clod_surrogate_residuals(const clod_surrogate *self, double *residuals);

/** Greatest restricted log likelihood, with the log prior of the slopes, both without constants. */
double clod_surrogate_likelihood(const clod_surrogate *self);

/** Correlation length along an input; INFINITY: a polynomial. */
double clod_surrogate_length(const clod_surrogate *self, size_t dimension);

clod_surrogate_kind clod_surrogate_kind_of(const clod_surrogate *self);

/** Leave every point out once, hyperparameters as they are. `stop` is asked at each; NULL: never.
 *  Errors  as clod_surrogate_create. */
bool clod_surrogate_leave_one_out(const clod_surrogate *self, const clod_stop *stop,
                                  clod_surrogate_check *check, clod_status *status);
