#pragma once
/**
 * @file clumps.h
 * Clumps of a free run: a measure (docs/clumps.md). It is sampled at every row of the series.
 */

#include "measure/clumps.h"
#include "parallel/exact.h"
#include "sim/free_measures.h"

/** All clumps, or those of one of the case's counts. */
typedef struct clod_clump_count {
    clod_clump_stats now;   ///< at the last sample
    clod_clump_stats mean;  ///< times s of the steady time
    clod_clump_stats most;  ///< the largest of each, in all the run
    clod_clump_sizes sizes; ///< times s of the steady time
} clod_clump_count;

/** What the measure remembers. */
typedef struct clod_clump_memory {
    double sampled;                         ///< s, time of the last sample
    double time;                            ///< s, of the steady time until then
    int64_t left;                           ///< times in it that a grain left its clump
    clod_exact lived;                       ///< s, sum of the times that they were
    double lived_least, lived_most;         ///< s
    int64_t lived_count[CLOD_TIME_CLASSES]; ///< how many were for so long
    clod_clump_count count[1 + CLOD_CASE_CLUMP_COUNTS]; ///< all, then those of the case
} clod_clump_memory;

extern const clod_free_measure CLOD_MEASURE_CLUMPS;
