#pragma once
/**
 * @file mesh_overlaps.h
 * Facets that share more than an edge or a corner: those of one plane that lie over each other
 * without having the same corners (both sides of a sheet that are cut along other diagonals, plates
 * that were drawn twice), and those that cut through each other (bodies pushed into each other).
 */

#include "mesh/mesh.h"

/** Steps of the search: so many, and so many for each facet; then it ends. */
#define CLOD_MESH_OVERLAPS_STEPS 5000000
#define CLOD_MESH_OVERLAPS_STEPS_EACH 90

/**
 * Note each facet that lies over an earlier one of the file, with the earliest below it, and each
 * that crosses another one, with the earliest of those (clod_mesh_pair_of says when that is so).
 * Gets overlaps, pairs that join all facets that lie over each other, and unsearched: facets that
 * are left when the steps are used up, as happens when the boxes about many of them meet: long
 * ones that lie aslant side by side.
 *
 * @param self  [in,out] facets are clean, neighbours are known over seams too
 * Errors  CLOD_FAILED: memory.   Threads pure.
 * Test    tests/mesh/test_mesh_overlaps.c, test_mesh_crossing.c
 */
bool clod_mesh_overlaps_find(clod_mesh *self, clod_status *status);
