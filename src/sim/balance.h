#pragma once
/**
 * @file balance.h
 * The books of a run in which grains come or go: what came, left by which way, is inside, and
 * that nothing is lost; flows over the steady time. A measure of free runs.
 */

#include "sim/free_measures.h"

/** What had come and gone at a moment; plain data. */
typedef struct clod_balance_count {
    double time;                     ///< s
    double mass_in, mass_inside;     ///< kg
    double mass_out[CLOD_EXITS + 1]; ///< kg; the last: removed by the run itself
    int64_t in, inside;              ///< grains
    int64_t out[CLOD_EXITS + 1];
} clod_balance_count;

/** What the balance remembers. */
typedef struct clod_balance {
    int64_t edges; ///< edges of the steady time's blocks that have been noted
    clod_balance_count start;
    clod_balance_count row; ///< of the last row of the series, or of the start
    clod_balance_count edge[CLOD_STEADY_BLOCKS + 1];
} clod_balance;

/** Test  tests/cli/test_gauges.py */
extern const clod_free_measure CLOD_MEASURE_BALANCE;
