#pragma once
/**
 * @file insertion_batch.h
 * Grains on the way into a state: what the ways to find them places have in common.
 */

#include "setup/insertion.h"
#include "setup/insertion_space.h"

/** Grains keep this fraction of their radius away from everything, against rounding. */
#define CLOD_INSERTION_CLEARANCE 1e-6

/** Random positions that are tried for one grain. */
#define CLOD_INSERTION_TRIES 4000

typedef struct clod_insertion_batch {
    const clod_insertion *what;
    clod_state *state; ///< borrowed
    size_t before;     ///< rows that it had
    double largest;    ///< m, largest radius with its clearance
    double volume;     ///< m3, of all grains
    size_t reached;    ///< grains that found a position
} clod_insertion_batch;

/** Radius of grain number g [m]. */
double clod_insertion_batch_radius(const clod_insertion_batch *self, size_t g);

/** Three random numbers of a grain. */
void clod_insertion_batch_draw(const clod_insertion_batch *self, size_t g, uint64_t number,
                               double u[3]);

/** Append grain number g, with its centre and its radius [m]; the next one has the next number. */
bool clod_insertion_batch_put(const clod_insertion_batch *self, size_t g,
                              const double sphere[4], clod_status *status);

/** Say that they do not fit; false. */
bool clod_insertion_batch_no_room(const clod_insertion_batch *self,
                                  const clod_insertion_space *space, clod_status *status);

/**
 * Loose layers from the bottom up, each grain appended as soon as it has its place.
 *
 * @param space  open, without a grid: each band of layers gets its own
 */
bool clod_insertion_layers_fill(clod_insertion_batch *self, clod_insertion_space *space,
                                clod_status *status);

/**
 * Random positions, the largest first, of grains whose places others keep (what->pieces->taker->keeper): the
 * same places as those of one process. Nothing is appended when one finds none: then fewer are reached.
 *
 * @param space  open, without a grid
 */
bool clod_insertion_kept_fill(clod_insertion_batch *self, clod_insertion_space *space,
                              clod_status *status);
