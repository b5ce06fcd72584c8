#pragma once
/**
 * @file mixing.h
 * Lacey's mixing index and angles of repose (docs/mixing.md): measures of free runs. They are taken
 * at every row of the series.
 */

#include <stdio.h>

#include "sim/free_measures.h"

/** Mean over the samples of the steady time. */
typedef struct clod_mixing_mean {
    int64_t samples[CLOD_STEADY_BLOCKS]; ///< that have a value
    double sum[CLOD_STEADY_BLOCKS];
} clod_mixing_mean;

/** Note a value, if it is one and in the steady time. */
void clod_mixing_mean_note(clod_mixing_mean *self, const clod_free_moment *now, double value);

/** Mean and standard deviation of the blocks' means; NAN of nothing. */
void clod_mixing_mean_of(const clod_mixing_mean *self, double *mean, double *deviation);

/** Write them times `scale`, with the unit, for a line of the report; in words where there are
 *  none. */
void clod_mixing_mean_write(FILE *out, const clod_mixing_mean *self, double scale,
                            const char *unit);

/** Columns of an index in the series; the first is the index. */
#define CLOD_MIXING_COLUMNS 5

/**
 * Errors  CLOD_FAILED: memory.   Threads  one per state.
 * Test    tests/cli/test_mixing.py
 */
extern const clod_free_measure CLOD_MEASURE_MIXING;
extern const clod_free_measure CLOD_MEASURE_REPOSE;
