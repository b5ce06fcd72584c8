#pragma once
/**
 * @file mesh_seams.h
 * T-junctions: where facets of different sizes meet along a line, a long edge has vertices of
 * others inside, and no edge has a partner of its own length.
 */

#include "mesh/mesh.h"

/**
 * Among open edges, find those with vertices of other open edges inside, within rounding
 * (self->weld), and the short edges along them; all become CLOD_MESH_EDGE_T, the long one's
 * neighbour a short one's facet and the reverse. Long edges that short ones do not cover count
 * in self->gaps.
 *
 * Errors  CLOD_FAILED: memory.   Threads pure.   Test  tests/mesh/test_mesh_seams.c
 */
bool clod_mesh_seams_find(clod_mesh *self, clod_status *status);
