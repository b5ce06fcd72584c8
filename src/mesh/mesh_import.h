#pragma once
/**
 * @file mesh_import.h
 * The only place that calls Assimp.
 */

#include "mesh/mesh_source.h"

/**
 * Let Assimp read a checked content: polygons are cut into triangles, everything else is left
 * as it is in the file.
 *
 * @param source   checked (clod_mesh_source_check); no other file is opened, whatever it names
 * @param corners  [out] [source->facets][3] places as in the file; owned (clod_memory_free)
 * Errors  CLOD_USAGE: Assimp refuses it, a coordinate is not finite; CLOD_FAILED: memory.
 * Threads safe: one at a time.   Test  tests/mesh/test_mesh_read.c
 */
bool clod_mesh_import(const clod_mesh_source *source, float (**corners)[3][3],
                      clod_status *status);
