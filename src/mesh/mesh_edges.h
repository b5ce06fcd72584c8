#pragma once
/**
 * @file mesh_edges.h
 * What lies over each edge of each facet.
 */

#include "mesh/mesh.h"

/** An edge by its vertices, in any order. */
static inline uint64_t clod_mesh_edges_key(uint32_t a, uint32_t b)
{
    return a < b ? (uint64_t)a << 32 | b : (uint64_t)b << 32 | a;
}

/**
 * Find the neighbour over every edge: open without one, non-manifold with several (then each
 * facet's neighbour is the next one around the edge's list), otherwise flat for now.
 *
 * @param self  [in,out] facets are clean; gets neighbours and edges
 * Errors  CLOD_FAILED: memory.   Threads pure.   Test  tests/mesh/test_mesh_edges.c
 */
bool clod_mesh_edges_pair(clod_mesh *self, clod_status *status);

/**
 * Turn facets whose normal disagrees with those of their neighbours: in each piece that edges of
 * two facets hold together, the smaller number. Edges where no turning helps are noted.
 *
 * Errors  CLOD_FAILED: memory.   Threads pure.   Test  tests/mesh/test_mesh_findings.c
 */
bool clod_mesh_edges_turn(clod_mesh *self, clod_status *status);

/**
 * Class the edges of two facets: flat when the far corner of the neighbour is out of the plane
 * by no more than 1/1000 of its distance from the edge (0.06 deg) or than rounding explains;
 * convex when it lies behind the normal or the neighbour is folded back; otherwise concave.
 * Note open and non-manifold edges.
 *
 * Threads pure.   Test  tests/mesh/test_mesh_edges.c
 */
void clod_mesh_edges_class(clod_mesh *self);
