#pragma once
/**
 * @file residence.h
 * How long grains were in: those that came during a run, this one or the one it goes on from,
 * and left in the steady time of this one.
 */

#include "sim/free_measures.h"

/** Of these grains. */
typedef struct clod_residence {
    int64_t grains;
    double mean, deviation;      ///< s, exact sums
    double tenth, median, ninth; ///< s, 10, 50, 90 %: by classes of 1 % (state/time_class.h)
} clod_residence;

/** Threads  pure.   Test  tests/cli/test_inlets.py */
clod_residence clod_residence_of(const clod_exchange *exchange);

/** A line of the report, classes of times in the summary and in residence.csv; nothing when
 *  nothing left. */
extern const clod_free_measure CLOD_MEASURE_RESIDENCE;
