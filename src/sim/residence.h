#pragma once
/**
 * @file residence.h
 * How long the grains that left were in: from when they came, or from the start of the run.
 */

#include "sim/free_measures.h"

/** Of all grains that left. */
typedef struct clod_residence {
    int64_t grains;
    double mean, deviation;      ///< s, exact sums
    double tenth, median, ninth; ///< s, 10, 50, 90 %: by classes of a tenth of a decade
} clod_residence;

/** Threads  pure.   Test  tests/cli/test_inlets.py */
clod_residence clod_residence_of(const clod_exchange *exchange);

/** A line of the report, and classes of times in the summary; nothing when nothing left. */
extern const clod_free_measure CLOD_MEASURE_RESIDENCE;
