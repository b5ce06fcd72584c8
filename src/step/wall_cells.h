#pragma once
/**
 * @file wall_cells.h
 * Shapes of walls within the wide skin of each grain: by cells, so that only what is near a
 * grain costs anything; or over all shapes as the slow obvious check. Both give the same list.
 */

#include "step/neighbour.h"

/** Note for every cell of self->grid which shapes may be near grains in it; false without memory. */
bool clod_wall_cells_fill(clod_neighbour *self, const clod_state *state);

/**
 * Candidates of the grains [begin, end) in ascending (i, wall, shape), with the walls where they
 * were at the last rebuild (self->build_rows).
 *
 * @param to  [in,out] they come behind those that are in it
 * @return    false without memory, or beyond CLOD_LIMITS_WALL_PAIRS
 * Threads    several, each with a `to` of its own.   Test  tests/step/test_many_walls.c
 */
bool clod_wall_cells_find(const clod_neighbour *self, const clod_state *state,
                          const clod_laws *laws, clod_chunk grains, clod_wall_candidates *to);

/** The same by looking at every shape for each of the grains. */
bool clod_wall_cells_find_all(const clod_neighbour *self, const clod_state *state,
                              const clod_laws *laws, clod_chunk grains,
                              clod_wall_candidates *to);

void clod_wall_cells_fini(clod_wall_cells *self);
