#pragma once
/**
 * @file plan_samples.h
 * Measured points of a table on their way to targets: repeats become one. For plan_tables.c, plan_shear.c,
 * plan_curves.c and plan_repose.c alone.
 */

#include "calibrate/plan_targets.h"

/** A measured point. */
typedef struct clod_plan_sample {
    double stress, value, error; ///< SI; error 0: the table has none; stress 0: there is none
    int64_t specimen;            ///< `seed` of the table
    clod_plan_repeats repeats;   ///< of a mean
    size_t lacking;              ///< points of a mean without an error
    clod_plan_common common;     ///< beside `error`
} clod_plan_sample;

/** Those of a table. */
typedef struct clod_plan_samples {
    clod_plan_sample *items; ///< [count] owned
    size_t count;
    double slope;             ///< of value over stress, 0: hardly any
    double *scratch;          ///< [count] owned
    const char *error_column; ///< where the table may tell the error of a point
    bool scatter_alone;       ///< how repeats scatter is an error also where none is stated
    const clod_curve *curve;  ///< of the targets; NULL: none
} clod_plan_samples;

/** Room for so many; false when there is none, which the report notes. */
bool clod_plan_samples_init(clod_plan_samples *self, clod_plan_maker *make, size_t room);

/** Free the content; an empty one is fine. */
void clod_plan_samples_fini(clod_plan_samples *self);

/** What all points of a table have in common; false after a complaint. */
bool clod_plan_samples_common(clod_plan_maker *self, size_t test, const clod_number *kind,
                              clod_plan_target *to);

/**
 * Repeats at one stress are one measurement of the material: the mean of the values, moved along the
 * slope to the mean of the stresses, with the larger of the stated error of that mean,
 * sqrt(sum e_i^2)/n, and the standard error from their scatter, s/sqrt(n) (clod_mean_of has the
 * source). In the order in which each stress first appears.
 *
 * A scatter of few specimens is a poor estimate, so those of all stresses are pooled: every point gets
 * their mean coefficient of variation, weighted by n - 1 (docs/theory/calibration.md).
 *
 * What all points of one seed have in common stays beside that.
 *
 * @param error  of each point; the larger of it and the table's counts; 0: the table's alone, and where a point
 *               has none, that of the mean is 0, or that of `scatter_alone`
 */
void clod_plan_samples_merge(clod_plan_samples *self, double error);

/** Warn of a table with several points where a specimen is twice in one: nothing tells then which of its rows belong
 *  together, and errors count as independent. */
void clod_plan_samples_warn_alike(clod_plan_maker *self, const clod_plan_samples *from);

/** Warn of a table, once for all entries of the plan that name it. */
void clod_plan_samples_warn(clod_plan_maker *self, const char *warning);

/** Largest error of the points. */
double clod_plan_samples_largest(const clod_plan_samples *self);

/**
 * Warn of a table of one specimen whose errors do not tell how specimens differ. An `error` of the plan may where it is above
 * those of the table: then there is none.
 *
 * @param common  with the plan's error
 * @param stated  largest error of the table's points; 0: it has none
 * @param what    "one specimen: scatter between specimens not included"
 */
void clod_plan_samples_warn_one(clod_plan_maker *self, const clod_plan_target *common,
                                double stated, const char *what);

/** A target of each point, or of those at a stress where one is given. */
void clod_plan_samples_make(clod_plan_maker *self, const clod_number *kind,
                            const clod_plan_target *common, const clod_plan_samples *from,
                            double stress);

/** Whether two stresses are one. */
bool clod_plan_samples_same(double stress, double other);
