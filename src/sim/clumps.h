#pragma once
/**
 * @file clumps.h
 * Clumps of a free run: a measure (docs/clumps.md). It is sampled at every row of the series.
 */

#include "measure/clumps_look.h"
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
    double sampled;                              ///< s, time of the last sample
    double time;                                 ///< s, of the steady time until then
    clod_clump_lives lives;                      ///< of grains that left their clumps in it
    clod_clump_count count[CLOD_CLUMPS_CHOICES]; ///< all, then those of the case
} clod_clump_memory;

extern const clod_free_measure CLOD_MEASURE_CLUMPS;
