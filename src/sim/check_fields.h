#pragma once
/**
 * @file check_fields.h
 * What fields cost a run (docs/fields.md), for `clod check`.
 */

#include "clod/check.h"

/** A run as it is planned. */
typedef struct clod_check_fields_run {
    double grains, step, duration; ///< s of simulated time, in steps of `step` s
    double pictures;               ///< snapshots
    double rows;                   ///< of all series: a test has no more samples
    double parts, beside;          ///< of a test: how many, and how many side by side; else 1
} clod_check_fields_run;

typedef struct clod_check_fields_cost {
    double clock; ///< s of one thread for all samples, when every grain is in every region
    double
        memory; ///< bytes: sums over samples of all parts, and those of a sample of all fields at once
    double disk;    ///< bytes of grids at the end and beside snapshots, before compression
    double stored;  ///< bytes of the sums in one checkpoint
    double columns; ///< of the series
} clod_check_fields_cost;

/** Errors  none.   Threads  pure.   Test  tests/cli/test_fields.py, tests/cli/test_grids_testers.py */
clod_check_fields_cost clod_check_fields_of(const clod_case *from,
                                            const clod_check_fields_run *run);
