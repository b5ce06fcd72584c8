#pragma once
/**
 * @file insertion.h
 * Random insertion of grains without overlap. Every random number is a function of seed, grain
 * id and draw, and grains are put one after the other, so a seed gives the same grains always.
 */

#include "config/sizes.h"
#include "setup/pieces.h"
#include "state/state.h"

/** What a group of grains takes. */
typedef struct clod_insertion_extent {
    double largest; ///< m, radius of the largest
    double volume;  ///< m3, of all grains
} clod_insertion_extent;

/** A group of grains to put. */
typedef struct clod_insertion {
    const char *name; ///< of the group in messages, for instance "grains.0"
    const clod_case_region *region;
    const clod_sizes *sizes;
    uint64_t seed;
    uint64_t first_id; ///< ids are first_id, first_id + 1, ...
    size_t count;
    uint16_t material;
    double density;                      ///< kg/m3
    double velocity[3];                  ///< m/s
    const clod_insertion_extent *extent; ///< borrowed; NULL: worked out when they are put
    clod_setup_pieces
        *pieces; ///< grains are given to it as they are made; NULL: the state keeps all
} clod_insertion;

/** What they take, from their sizes; `extent` is not read. Threads: pure. */
clod_insertion_extent clod_insertion_measure(const clod_insertion *self);

/**
 * Put grains at random positions in a region, the largest first. When they are too many for
 * that (a solid fraction above about 0.3), they are put in loose layers from the bottom up,
 * each grain at a random position in its cell (box) or of its part of a ring (annulus).
 *
 * The grains are inside the region and clear of each other, of the walls of the state and of
 * the grains that are in it; beside the shell of a cylinder they are on its side.
 *
 * Grains in layers are appended as they get their places, which takes no list of them; those at
 * random positions when all have one.
 *
 * @param state  [in,out] walls and domain are read, grains are appended in order of id
 * Errors  CLOD_USAGE: they do not fit; the text has the wanted and the reached count.
 * Threads one at a time; same grains for the same seed.
 * Test    tests/setup/test_setup_insertion.c
 */
bool clod_insert_region(clod_state *state, const clod_insertion *what, clod_status *status);

/**
 * Put grains into an upright annulus (or cylinder) that is open upwards, filled at random from
 * the bottom: the region's height is not read.
 *
 * @param state   [in,out] as above
 * @param height  [out] height of the highest point of any grain put [m]
 */
bool clod_insert_annulus_column(clod_state *state, const clod_insertion *what, double *height,
                                clod_status *status);
