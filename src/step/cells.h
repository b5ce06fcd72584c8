#pragma once
/**
 * @file cells.h
 * Pairs of grains within the wide skin: by cells, or over all pairs as the slow obvious check.
 * Both give the same list.
 */

#include "step/neighbour.h"

/** Most cells that a grid for so many grains has: coarser for scattered ones, and int32 counts.
 */
double clod_cells_most(size_t grains);

/** Fill self->pairs in ascending (i, j); false without memory. */
bool clod_cells_find_pairs(clod_neighbour *self, const clod_state *state);

/** The same by looking at every pair. */
bool clod_cells_all_pairs(clod_neighbour *self, const clod_state *state);
