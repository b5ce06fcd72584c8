#pragma once
/**
 * @file bonds.h
 * What joins grains of a clump (docs/clumps.md).
 */

#include "measure/survey.h"

/** Two grains that hang together. */
typedef struct clod_bond {
    int32_t i, j; ///< rows
} clod_bond;

/** The bonds of a moment that own grains have, and what else clumps need of it. */
typedef struct clod_bonds {
    clod_bond *bond; ///< [count] owned, as the rest
    size_t count, room;
    bool *on_wall;         ///< [grains.count] whether an own grain touches a wall
    double largest_mass;   ///< kg, of the whole bed
    double largest_radius; ///< m, likewise
} clod_bonds;

/**
 * Find the bonds: closed contacts of two grains whose pull-off force exceeds `number` times the
 * weight of the lighter one. Without gravity any pull is enough.
 *
 * @param self    [out] clod_bonds_fini in any case
 * @param here    its contacts have strength; without there are no bonds
 * @param number  Bond number, 0 or more
 * @return        false on all ranks alike
 * Errors  CLOD_FAILED: memory.   Threads  one of each rank.   Test  tests/measure/test_clumps.c
 */
bool clod_bonds_find(clod_bonds *self, const clod_survey_part *here, double number,
                     clod_status *status);

void clod_bonds_fini(clod_bonds *self);
