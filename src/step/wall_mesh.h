#pragma once
/**
 * @file wall_mesh.h
 * Candidates at meshes. At a rebuild one walk through the tree of a surface finds the facets
 * near a grain, and with them the patches and slots; a near list looks at those facets alone.
 */

#include "step/neighbour.h"

/** A grain at a surface whose first shape is `shape` of `wall`. */
typedef struct clod_wall_mesh_place {
    size_t grain;
    int32_t wall, shape;
} clod_wall_mesh_place;

/** First shape of the surface of a mesh's shape. */
int32_t clod_wall_mesh_first(const clod_wall_rows *rows, int32_t wall, int32_t shape);

/**
 * Add the patches and slots of a surface that are within the wide skin of a grain, ascending by
 * shape, each with its facets.
 *
 * @param to  [in,out] they come behind those that are in it
 * @return    false without memory, or beyond CLOD_LIMITS_WALL_PAIRS
 * Threads    several, each with a `to` of its own.   Test  tests/step/test_many_walls.c
 */
bool clod_wall_mesh_find(const clod_neighbour *self, const clod_state *state,
                         const clod_laws *laws, clod_wall_mesh_place at,
                         clod_wall_candidates *to);

/**
 * Whether a candidate at a mesh is within `reach` of a place p of its grain [m]; notes which of
 * the facets of a first slot are.
 *
 * @param rows  where the walls are
 */
bool clod_wall_mesh_mark(clod_wall_candidates *self, const clod_wall_candidate *c,
                         const clod_wall_rows *rows, const double p[3], double reach);
