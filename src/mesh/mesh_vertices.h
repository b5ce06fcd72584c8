#pragma once
/**
 * @file mesh_vertices.h
 * Vertices from the corners of facets. STL knows no vertices: facets that meet repeat the same
 * numbers, or nearly the same.
 */

#include "mesh/mesh.h"

#define CLOD_MESH_WELD_STEPS                                                                   \
    4.0 ///< of a float at the farthest coordinate: up to that vertices are one

/**
 * Corners of the same bits become one vertex; facets get their vertices.
 *
 * @param self     [in,out] gets vertices as in the file, in its order, and facets
 * @param corners  [count][3] places as in the file
 * Errors  CLOD_FAILED: memory.   Threads pure.   Test  tests/mesh/test_mesh_read.c
 */
bool clod_mesh_vertices_join(clod_mesh *self, const float (*corners)[3][3], size_t count,
                             clod_status *status);

/** Bring vertices to their place in metres. Errors CLOD_USAGE: one is beyond 1e7 m. */
bool clod_mesh_vertices_place(clod_mesh *self, const clod_mesh_placing *placing,
                              clod_status *status);

/**
 * Vertices nearer than self->weld become the first of them in the file. self->weld is four steps
 * of a float at the farthest coordinate of the file (2^-21 of it). Programs compute in double
 * precision and round to the nearest float, so what was one point differs by one step in each
 * coordinate at most (1.7 steps in distance); numbers read from text add two. No edge longer
 * than eight steps vanishes.
 *
 * Errors  CLOD_FAILED: memory.   Threads pure.   Test  tests/mesh/test_mesh_findings.c
 */
bool clod_mesh_vertices_weld(clod_mesh *self, clod_status *status);
