#pragma once
/**
 * @file check_fields.h
 * What fields cost a run (docs/fields.md), for `clod check`.
 */

#include "clod/check.h"

typedef struct clod_check_fields_cost {
    double clock;   ///< s of one thread for all samples, when every grain is in every region
    double memory;  ///< bytes: sums over samples, and those of a sample of all fields at once
    double disk;    ///< bytes of grids at the end and beside snapshots, before compression
    double columns; ///< of the series
} clod_check_fields_cost;

/**
 * @param duration  s of simulated time, in steps of `step` s
 * @param pictures  snapshots
 * Errors  none.   Threads  pure.   Test  tests/cli/test_fields.py
 */
clod_check_fields_cost clod_check_fields_of(const clod_case *from, double grains, double step,
                                            double duration, double pictures);
