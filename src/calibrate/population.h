#pragma once
/**
 * @file population.h
 * Places drawn as likely as a density makes them, from all of the unit cube: with several summits each has its share of
 * them. Chains begin there, and step along their differences.
 */

#include "calibrate/chain.h"
#include "clod/status.h"

typedef struct clod_population {
    size_t count;
    double *places;  ///< [count][dimensions] owned
    size_t *chosen;  ///< [count][choices] owned
    double *density; ///< [count] owned, logarithms
} clod_population;

/**
 * Draw them by a sequence of powers of the density, from 0 to 1. At each they are drawn anew by their weights, and
 * each steps along the difference of two members, draws one of its whole numbers anew, and does both at once.
 *
 * @param setup  dimensions, choices, options, seed, stream (behind those of its chains), density and stop
 * @param self   [out] owned content (clod_population_fini), in any case
 * Errors  CLOD_FAILED: memory; CLOD_INTERRUPTED.   Threads  safe.
 * Source  Del Moral, Doucet and Jasra, J. R. Stat. Soc. B 68 (2006) 411, 3.3.2.3; ter Braak, Stat. Comput. 16 (2006)
 *         239; Douc and Cappe, ISPA 2005 (systematic resampling).
 * Test    tests/calibrate/test_population.c
 */
bool clod_population_create(const clod_chain_setup *setup, size_t count, clod_population *self,
                            clod_status *status);

/** Two different members, and how far along their difference: three random numbers in (0, 1) for them. */
typedef struct clod_population_dice {
    double one, other, scale;
} clod_population_dice;

/**
 * A place from another one along the difference of two members. As likely to be proposed as the way back, as long as the
 * members stay as they are.
 *
 * @param next  [out] [dimensions]
 * @return      whether it is inside the cube
 */
bool clod_population_propose(const clod_population *self, size_t dimensions,
                             const clod_population_dice *dice, const double *from,
                             double *next);

void clod_population_fini(clod_population *self);
