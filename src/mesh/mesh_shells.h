#pragma once
/**
 * @file mesh_shells.h
 * Pieces of a mesh that no edge connects.
 */

#include "mesh/mesh.h"

/**
 * Number the pieces in the order of their first facets: gets shell and view.shell_count.
 *
 * Errors  CLOD_FAILED: memory.   Threads pure.   Test  tests/mesh/test_mesh_findings.c
 */
bool clod_mesh_shells_number(clod_mesh *self, clod_status *status);
