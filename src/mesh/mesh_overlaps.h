#pragma once
/**
 * @file mesh_overlaps.h
 * Facets of one plane that lie over each other without having the same corners: both sides of a
 * sheet that are cut along other diagonals, plates that were drawn twice.
 */

#include "mesh/mesh.h"

/** Steps of the search: so many, and so many for each facet; then it ends. */
#define CLOD_MESH_OVERLAPS_STEPS 5000000
#define CLOD_MESH_OVERLAPS_STEPS_EACH 90

/**
 * Note each facet that lies over an earlier one of the file: all corners of one are within
 * self->weld of the plane of the other, and they have an area in common that is wider
 * than twice that in every direction of the plane. Gets overlaps, pairs that join all facets
 * that lie over each other, and unsearched: facets that are left when the steps are used up, as
 * happens when the boxes about many of them meet: long ones that lie aslant side by side.
 *
 * Errors  CLOD_FAILED: memory.   Threads pure.   Test  tests/mesh/test_mesh_overlaps.c
 */
bool clod_mesh_overlaps_find(clod_mesh *self, clod_status *status);
