#pragma once
/**
 * @file misfit.h
 * How far measured values are from what surrogates say, and how likely that is: targets of one test have
 * errors in common, and errors that were estimated from few specimens are not known.
 * docs/theory/calibration.md has the equations.
 */

#include "calibrate/plan.h"
#include "calibrate/surrogate.h"

/** Opaque. */
typedef struct clod_misfit clod_misfit;

/** Runs, and what was fitted to them. */
typedef struct clod_misfit_runs {
    const clod_plan *plan;
    size_t points;
    const double *results; ///< [points][seeds][targets], SI; NAN: failed, or not defined
    const clod_surrogate *const
        *surrogates; ///< [targets]; NULL: held back, and the runs give none
} clod_misfit_runs;

/**
 * Groups of targets with their correlations.
 *
 * @param runs  its plan is borrowed
 * @return      owned (clod_misfit_destroy), or NULL without memory
 * Errors  none.   Threads  safe.
 * Source  docs/theory/calibration.md, "Errors in common" and "Errors that are not known".
 * Test    tests/calibrate/test_misfit.c, test_coverage_specimens.c
 */
clod_misfit *clod_misfit_create(const clod_misfit_runs *runs);

void clod_misfit_destroy(clod_misfit **self);

/** Groups, those held back too. */
size_t clod_misfit_count(const clod_misfit *self);

/** Numbers of the caller's that the functions below need. */
size_t clod_misfit_room(const clod_misfit *self);

/**
 * Log density of the measured values of all used targets, without constants.
 *
 * @param told  [targets] what the surrogates say
 * @param room  [clod_misfit_room]
 * Errors  none.   Threads  one per room.
 */
double clod_misfit_density(const clod_misfit *self, const clod_surrogate_value *told,
                           double *room);

/**
 * The errors that are not known, drawn: for used targets as likely as the measured values make them.
 *
 * @param dice       [groups] uniform in (0, 1)
 * @param variances  [out] [targets] of a measured value about what the surrogate says; NAN without one
 * @return           chi-square of the used targets at these errors
 */
double clod_misfit_draw(const clod_misfit *self, const clod_surrogate_value *told,
                        const double *dice, double *variances, double *room);

/** Degrees of freedom of the errors of the group that a target is in; INFINITY: they are known. */
double clod_misfit_degrees(const clod_misfit *self, size_t target);

/** Correlation of two targets: of what the surrogates do not know, and of the laboratory's errors. */
void clod_misfit_correlation(const clod_misfit *self, size_t a, size_t b, double *runs,
                             double *laboratory);
