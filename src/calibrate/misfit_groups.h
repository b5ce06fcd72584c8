#pragma once
/**
 * @file misfit_groups.h
 * What a misfit is made of; for misfit.c and misfit_groups.c alone.
 */

#include "calibrate/misfit.h"

#define CLOD_MISFIT_NODES 16

/** Used targets of one test, or those that are held back. */
typedef struct clod_misfit_group {
    size_t test;
    bool held_back;
    size_t count;
    size_t *targets; ///< [count] owned, index of each
    double *runs;    ///< [count][count] owned, correlation of what the surrogates do not know
    double *laboratory; ///< [count][count] owned, of the rest of the errors of measured values
    double *
        common; ///< [count][count] owned, covariance of the measured values by the mean preshears that prorated them
    double degrees; ///< of errors that were estimated; INFINITY: none were
    size_t nodes;
    double factors[CLOD_MISFIT_NODES]; ///< [nodes] of their variances, equally likely
} clod_misfit_group;

struct clod_misfit {
    const clod_plan *plan;
    clod_misfit_group *groups; ///< [count] owned
    size_t count;
    size_t *group_of; ///< [targets] owned
};

/** Fill the correlations and factors of a group, whose targets are there; false without memory. */
bool clod_misfit_groups_fill(const clod_misfit_runs *runs, clod_misfit_group *self);
