#pragma once
/**
 * @file clumps.h
 * Clumps: grains that hang together by adhesive contacts (docs/clumps.md). Nothing here depends
 * on the order of rows or contacts: grains are gone through by their ids.
 */

#include "state/clump_class.h"
#include "state/contact_source.h"
#include "state/ids.h"

/** What joins two grains. */
typedef struct clod_bond {
    int32_t i, j; ///< rows
} clod_bond;

/** All bonds of a moment. */
typedef struct clod_bonds {
    clod_bond *bond; ///< [count] owned, as the rest
    size_t count, room;
    bool *on_wall; ///< [grains.count] whether a grain touches a wall
    clod_ids ids;  ///< of all grains
} clod_bonds;

/**
 * Find the bonds: closed contacts of two grains whose pull-off force exceeds `number` times the
 * weight of the lighter one. Without gravity any pull is enough.
 *
 * @param self      [out] clod_bonds_fini in any case
 * @param contacts  with strength; without there are no bonds
 * @param number    Bond number, 0 or more
 * Errors  CLOD_FAILED: memory.   Threads  pure.   Test  tests/measure/test_clumps.c
 */
bool clod_bonds_find(clod_bonds *self, const clod_state *state,
                     const clod_contact_source *contacts, double number, clod_status *status);

void clod_bonds_fini(clod_bonds *self);

/** Which clumps are searched for. */
typedef struct clod_clump_choice {
    int64_t least;             ///< grains of a clump, 2 or more
    const clod_outlet *region; ///< only grains in it, and bonds between them; NULL: all
    bool free;                 ///< only clumps of which no grain touches a wall
} clod_clump_choice;

typedef struct clod_clump {
    uint64_t id; ///< smallest of its grains'
    int32_t grains;
    double mass;   ///< kg
    double volume; ///< m3, of its grains
} clod_clump;

typedef struct clod_clumps {
    clod_clump *clump; ///< [count] ascending by id; owned, as the rest
    size_t count;
    int32_t *of;        ///< [grains.count] number of each grain's clump; -1: none
    double grains_mass; ///< kg, of all grains that were counted
} clod_clumps;

/**
 * Find the clumps.
 *
 * @param self   [out] clod_clumps_fini in any case
 * @param bonds  of this state
 * Errors  CLOD_FAILED: memory.   Threads  pure.   Test  tests/measure/test_clumps.c
 */
bool clod_clumps_find(clod_clumps *self, const clod_state *state, const clod_bonds *bonds,
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
 * Sum up what clumps are. d10 is the diameter of the smallest clump which with all smaller ones
 * has 10 % of the mass in clumps; and so on. All 0 without clumps.
 *
 * Errors  CLOD_FAILED: memory.   Threads  pure.   Test  tests/measure/test_clumps.c
 */
bool clod_clumps_sum_up(const clod_clumps *self, clod_clump_stats *stats,
                        clod_clump_sizes *sizes, clod_status *status);
