#pragma once
/**
 * @file number.h
 * Which results of a test can be targets, and how they are read from the folder of its run.
 */

#include "calibrate/plan.h"

/** Bit of a clod_case_kind. */
#define CLOD_NUMBER_OF(kind) (1U << (kind))

/** Relative: as clod locus tells consolidation stresses apart. */
#define CLOD_NUMBER_SAME_STRESS 0.02

/** One kind of number; its measure says its unit for people. */
typedef struct clod_number {
    const char *key;
    const char *unit; ///< SI
    clod_plan_measure measure;
    double least, most; ///< SI: what a measured value may be
    unsigned kinds;     ///< of cases that have it: CLOD_NUMBER_OF each
    unsigned
        at_stress; ///< of cases where it is that of a normal stress, which the plan must give
} clod_number;

/** The kind of a number of a test of this kind of case; NULL: there is none. Of a free run every path of
 *  its summary is one. */
const clod_number *clod_number_find(clod_case_kind kind, const char *key);

/** "; did you mean phi_e?" or "; it has phi_lin, ...": after an unknown number. */
const char *clod_number_hint(clod_case_kind kind, const char *key, char *buffer, size_t size);

/**
 * The numbers of all targets of a test in the results folder of a finished run.
 *
 * @param values  [out] [targets] SI; NAN where the test does not define one; those of other tests stay
 * Errors  CLOD_USAGE: a free run's summary has no such number, with the nearest; a file that is damaged;
 *         CLOD_FAILED: disk, memory.   Threads  safe.   Test  tests/calibrate/test_calibrate.py
 */
bool clod_number_read(const clod_plan *plan, size_t test, const char *folder, double *values,
                      clod_status *status);
