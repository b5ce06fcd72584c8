#pragma once
/**
 * @file residence.h
 * How long the grains that left were in: from when they came, or from the start of the run.
 */

#include <jansson.h>
#include <stdint.h>
#include <stdio.h>

#include "state/changes.h"

/** Of all grains that left. */
typedef struct clod_residence {
    int64_t grains;
    double mean, deviation;      ///< s, exact sums
    double tenth, median, ninth; ///< s, 10, 50, 90 %: by classes of a tenth of a decade
} clod_residence;

/** Threads  pure.   Test  tests/cli/test_inlets.py */
clod_residence clod_residence_of(const clod_exchange *exchange);

/** A line for people; none when nothing left. */
void clod_residence_report(FILE *out, const clod_exchange *exchange);

/** The same for programs, with the classes; NULL when nothing left. */
json_t *clod_residence_json(const clod_exchange *exchange);
