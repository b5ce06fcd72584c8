#pragma once
/**
 * @file cells.h
 * Pairs of grains within the wide skin: by cells, or over all pairs as the slow obvious check.
 * Both give the same list.
 */

#include "step/neighbour.h"

/** Fill self->pairs in ascending (i, j); false without memory. */
bool clod_cells_find_pairs(clod_neighbour *self, const clod_state *state);

/** The same by looking at every pair. */
bool clod_cells_all_pairs(clod_neighbour *self, const clod_state *state);
