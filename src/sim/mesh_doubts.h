#pragma once
/**
 * @file mesh_doubts.h
 * What the mesh doctor says about the meshes of a case.
 */

#include "clod/case.h"
#include "clod/status.h"

#define CLOD_MESH_DOUBTS_TEXT 512

/** Told of each mesh: something is likely wrong, or only worth a look. */
typedef void (*clod_mesh_doubts_tell)(void *context, bool wrong, const char *text);

/**
 * Read the mesh files of a case again and tell what is doubtful: a unit that looks wrong, coarse
 * rounding, facets that are too fine; and, in one text for each file, open edges, slivers and
 * facets that were dropped or turned.
 *
 * @param radius  m, of a mean grain; 0: not known
 * Errors  as clod_mesh_read.   Threads  pure.   Test  tests/cli/test_check_mesh.py
 */
bool clod_mesh_doubts(const clod_case *from, double radius, clod_mesh_doubts_tell tell,
                      void *context, clod_status *status);
