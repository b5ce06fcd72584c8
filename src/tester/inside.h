#pragma once
/**
 * @file inside.h
 * Bulk density of a bed away from what holds it. Grains lie looser beside a wall, and a cell a few grains wide
 * is mostly that: its rho_b is not that of the same solid in a hopper.
 */

#include "state/state.h"

#define CLOD_INSIDE_APART 1.5 ///< mean diameters from sides, base, lid and the tips of bars

/** Where a bed is [m]. */
typedef struct clod_inside {
    double inner, outer; ///< radii of its sides about z; inner 0: none
    double low, high;    ///< heights of base and lid, or of the tips of their bars
    double plane;        ///< above it the sides are moved
    double shift;        ///< by so much along x
} clod_inside;

/**
 * Mass of grains, and of parts of grains, in the room that is CLOD_INSIDE_APART mean diameters and more from what
 * holds the bed, over its volume.
 *
 * @return  kg/m3; NAN where less than a mean diameter of the bed is left, across or along, or no grain is in it
 * Errors  none.   Threads  pure.
 * Source  docs/theory/ring-shear.md.   Test  tests/tester/test_inside.c, tests/python/test_inside_density.py
 */
double clod_inside_density(const clod_inside *bed, const clod_state *state);
