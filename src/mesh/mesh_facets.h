#pragma once
/**
 * @file mesh_facets.h
 * Facets that count twice or not at all are dropped; those of a bad shape are noted.
 */

#include "mesh/mesh.h"

/**
 * Drop degenerate facets (two corners in one vertex, or no corner farther from the opposite edge
 * than self->weld) and all but the first of facets with the same corners, in any order; then
 * vertices that no facet has. Note needles and slivers among the rest: a height over the longest
 * edge of less than 1/100 of it, with the shortest edge below 1/100 (needle) or not (sliver).
 *
 * Errors  CLOD_USAGE: no facet is left; CLOD_FAILED: memory.   Threads pure.
 * Test    tests/mesh/test_mesh_findings.c
 */
bool clod_mesh_facets_clean(clod_mesh *self, clod_status *status);
