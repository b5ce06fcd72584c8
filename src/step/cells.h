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

/** Number of the cell of a place. */
static inline int32_t clod_cells_at(const clod_cells_grid *grid, const double p[3])
{
    const int32_t z = clod_cells_along(grid, 2, p[2]);
    const int32_t y = clod_cells_along(grid, 1, p[1]);
    return (z * grid->n[1] + y) * grid->n[0] + clod_cells_along(grid, 0, p[0]);
}

/** Most cells that a grid for so many grains has: coarser for scattered ones, and int32 counts.
 */
double clod_cells_most(size_t grains);

/**
 * Grains by cell of self->grid, for the search, in four steps: room for the cells, which are empty;
 * the grains of a chunk counted; the numbers added up; the grains of a chunk entered. Afterwards
 * cell_start[c + 1] is where cell c begins in cell_item and cell_place; the order within a cell is
 * any.
 *
 * @param shared  other threads do other chunks at the same time
 * @return        begin: false without memory
 * Threads        count and enter: several, each with other grains
 */
bool clod_cells_begin(clod_neighbour *self, size_t grains);
void clod_cells_count(clod_neighbour *self, const clod_state *state, clod_chunk grains,
                      bool shared);
void clod_cells_add(clod_neighbour *self);
void clod_cells_enter(clod_neighbour *self, const clod_state *state, clod_chunk grains,
                      bool shared);

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
