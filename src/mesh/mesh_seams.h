#pragma once
/**
 * @file mesh_seams.h
 * T-junctions: where facets of different sizes meet along a line, a long edge has vertices of
 * others inside, and no edge has a partner of its own length.
 */

#include "mesh/mesh.h"

/**
 * Cut open edges at vertices of open edges that lie inside them, within rounding (self->weld).
 * Edges that were cut, or have a piece in common with another, become CLOD_MESH_EDGE_T; those
 * with a piece in common are neighbours, the first such piece deciding. So both sides of a line
 * may be divided as they like. Pieces that an edge has for itself are noted as open, those that
 * more than two share as non-manifold.
 *
 * Errors  CLOD_FAILED: memory.   Threads pure.   Test  tests/mesh/test_mesh_seams.c
 */
bool clod_mesh_seams_find(clod_mesh *self, clod_status *status);
