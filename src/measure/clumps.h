#pragma once
/**
 * @file clumps.h
 * Clumps: grains that hang together by adhesive contacts (docs/clumps.md). Where ranks have the bed,
 * each finds what hangs together of its own grains, and rank 0 joins what bonds across ranks do
 * (clumps_join.h). Nothing here depends on the order of rows or contacts, nor on whose they are.
 */

#include "measure/bonds.h"
#include "state/clump_class.h"

/** Which clumps are searched for; plain data. */
typedef struct clod_clump_choice {
    int64_t least; ///< grains of a clump, 2 or more
    bool cuts;     ///< only grains in the region, and bonds between them
    bool free;     ///< only clumps of which no grain touches a wall
    clod_outlet region;
} clod_clump_choice;

typedef struct clod_clump {
    uint64_t id; ///< smallest of its grains'
    int32_t grains;
    double mass;   ///< kg
    double volume; ///< m3, of its grains
} clod_clump;

/** What a grain knows of its clump. */
typedef struct clod_clump_name {
    uint64_t id;
    int64_t grains; ///< 0: it is in none
} clod_clump_name;

typedef struct clod_clumps {
    // of rank 0, or of a process alone
    clod_clump *clump; ///< [count] of all ranks, ascending by id; owned, as the rest
    size_t count;
    double grains_mass; ///< kg, of all grains that were counted
    // of each rank
    clod_clump_name *name; ///< [names] of what hangs together here
    size_t names;
    int32_t *of; ///< [grains.count] number of each own grain's name; -1: in no clump
} clod_clumps;

/**
 * Find the clumps.
 *
 * @param self   [out] clod_clumps_fini in any case
 * @param bonds  of this moment
 * @return       false on all ranks alike
 * Errors  CLOD_FAILED: memory.   Threads  one of each rank, all at the same time.
 * Test    tests/measure/test_clumps.c, test_clumps_ranks.c, tests/step/test_ranks_clumps.c
 */
bool clod_clumps_find(clod_clumps *self, const clod_survey_part *here, const clod_bonds *bonds,
                      const clod_clump_choice *choice, clod_status *status);

void clod_clumps_fini(clod_clumps *self);

/** What clumps of a moment are, all together. */
typedef struct clod_clump_stats {
    double number;        ///< of clumps
    double grains;        ///< in clumps
    double mass;          ///< kg, in clumps
    double share;         ///< of the mass of all grains that were counted
    double mean;          ///< grains of a clump
    double mean_by_mass;  ///< grains of the clump that a kg in clumps is in
    double largest;       ///< grains
    double largest_mass;  ///< kg, of the clump with most mass
    double d10, d50, d90; ///< m, diameter of a ball of the solid volume, by mass
} clod_clump_stats;

/** Number and mass of clumps by class. */
typedef struct clod_clump_sizes {
    double number[CLOD_CLUMP_CLASSES];
    double mass[CLOD_CLUMP_CLASSES]; ///< kg
} clod_clump_sizes;

/**
 * Sum up what clumps are (clumps_stats.c). d10 is the diameter of the smallest clump which with all
 * smaller ones has 10 % of the mass in clumps; and so on. All 0 without clumps.
 *
 * Errors  CLOD_FAILED: memory.   Threads  pure.   Test  tests/measure/test_clumps.c
 */
bool clod_clumps_sum_up(const clod_clumps *self, clod_clump_stats *stats,
                        clod_clump_sizes *sizes, clod_status *status);
