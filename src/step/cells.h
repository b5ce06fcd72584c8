#pragma once
/**
 * @file cells.h
 * Pairs of grains within the wide skin: by cells, or over all pairs as the slow obvious check.
 * Both give the same list.
 */

#include "step/neighbour.h"

/** Grid for the grains at the last rebuild; there is at least one grain. */
clod_cells_grid clod_cells_grid_of(const clod_neighbour *self, const clod_state *state);

/** Number of the cell along an axis in which a coordinate is, or the nearest one. */
static inline int32_t clod_cells_along(const clod_cells_grid *grid, int axis, double x)
{
    const double at = (x - grid->min[axis]) * grid->inverse_width[axis];
    const int32_t last = grid->n[axis] - 1;
    return !(at > 0.0) ? 0 : at >= (double)last ? last : (int32_t)at;
}

/** Most cells that a grid for so many grains has: coarser for scattered ones, and int32 counts.
 */
double clod_cells_most(size_t grains);

/** Grains by cell of self->grid, for the search; false without memory. */
bool clod_cells_fill(clod_neighbour *self, const clod_state *state);

/**
 * Later partners of grains [begin, end), in ascending (i, j), behind those that are in `to`;
 * to->start of each is where its own begin.
 *
 * @return  false when there is no more room in `to`
 * Threads  several, each with a `to` of its own and other grains
 */
bool clod_cells_find_pairs(const clod_neighbour *self, const clod_state *state, size_t begin,
                           size_t end, clod_pairs *to);

/** The same by looking at every pair. */
bool clod_cells_all_pairs(clod_neighbour *self, const clod_state *state);
