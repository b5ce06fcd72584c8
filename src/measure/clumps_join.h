#pragma once
/**
 * @file clumps_join.h
 * What hangs together in each rank, joined to clumps by the bonds across ranks.
 */

#include "measure/clump_sum.h"
#include "measure/clumps.h"

/** Grains of a rank that hang together by bonds that it knows, all of a clump or some of it. No gaps:
 *  it is sent as it is. */
typedef struct clod_clump_part {
    uint64_t id; ///< smallest of its grains'
    int32_t grains;
    int32_t walled;      ///< whether one of them touches a wall
    clod_clump_sum mass; ///< in units of clod_clump_units
    clod_clump_sum volume;
} clod_clump_part;

/** A bond across ranks by its grain with the smaller id, which both ranks name with their part. */
typedef struct clod_clump_link {
    uint64_t id;
    uint64_t part; ///< number
} clod_clump_link;

/** All parts of a rank. */
typedef struct clod_clump_parts {
    clod_clump_part *part; ///< [parts] owned, as the next
    clod_clump_link *link; ///< [links]
    size_t parts, links;
} clod_clump_parts;

/** What one is in a sum. */
typedef struct clod_clump_units {
    double mass, volume; ///< kg, m3
} clod_clump_units;

/**
 * Join them: the clumps of rank 0, and the names of each rank's parts.
 *
 * @param self   [in,out] without clumps and names
 * @param ranks  NULL: this process has all grains
 * @return       false without memory on any rank, on all alike
 * Threads  one of each rank, all at the same time.   Test  tests/step/test_ranks_clumps.c
 */
bool clod_clumps_join(clod_clumps *self, clod_ranks *ranks, const clod_clump_parts *mine,
                      const clod_clump_units *units, const clod_clump_choice *choice,
                      clod_status *status);
