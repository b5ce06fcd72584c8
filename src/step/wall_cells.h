#pragma once
/**
 * @file wall_cells.h
 * Shapes of walls within the wide skin of each grain: by cells, so that only what is near a
 * grain costs anything; or over all shapes as the slow obvious check. Both give the same list.
 */

#include "step/neighbour.h"

/**
 * Fill self->walls in ascending (i, wall, shape) with the walls where they were at the last
 * rebuild (self->build_rows).
 *
 * @return  false without memory, or beyond CLOD_LIMITS_WALL_PAIRS
 * Threads  one per search.   Test  tests/step/test_many_walls.c
 */
bool clod_wall_cells_find(clod_neighbour *self, const clod_state *state, const clod_laws *laws);

/** The same by looking at every shape for every grain. */
bool clod_wall_cells_find_all(clod_neighbour *self, const clod_state *state,
                              const clod_laws *laws);

void clod_wall_cells_fini(clod_wall_cells *self);
