#pragma once
/**
 * @file study.h
 * The course of a calibration, whoever computes the results: design, further points, posterior.
 */

#include "calibrate/posterior.h"
#include "calibrate/stop.h"

/** Where results come from: simulations, or a formula in a test. */
typedef struct clod_study_source {
    /**
     * Results of points [first, first + count), all packings.
     *
     * @param places   [first + count][parameters], in [0, 1]
     * @param results  [out] [first + count][seeds][targets], of these points; NAN: none
     */
    bool (*compute)(void *context, size_t first, size_t count, const double *places,
                    double *results, clod_status *status);
    /** Seconds on the clock that a point has taken, over the first `points`; 0: not known. */
    double (*seconds)(void *context, size_t points);
    /** Tell people how far it is; NULL: nobody is told. */
    void (*tell)(void *context, const char *text);
    /** Look at the first point, when it is computed; NULL: nobody does. */
    void (*look)(void *context);
    void *context;
    const clod_stop *stop; ///< asked while posteriors are made; NULL: never
} clod_study_source;

typedef struct clod_study {
    size_t points, designed;   ///< all, and those of the design before any posterior
    double *places;            ///< [points][parameters] owned
    double *results;           ///< [points][seeds][targets] owned
    clod_posterior *posterior; ///< owned
} clod_study;

/**
 * Compute the design, then, in up to three batches, points that stand for the posterior.
 *
 * @param study  [out] owned content (clod_study_fini), also after an error: what was computed
 * Errors  CLOD_USAGE: the budget is too small; CLOD_FAILED: results, memory; CLOD_INTERRUPTED.
 * Threads those of the source.   Test  tests/calibrate/test_coverage.c
 */
bool clod_study_run(const clod_plan *plan, const clod_study_source *source, clod_study *study,
                    clod_status *status);

void clod_study_fini(clod_study *self);
