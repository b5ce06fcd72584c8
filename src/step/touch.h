#pragma once
/**
 * @file touch.h
 * Contacts with meshes: the stage before `wall` finds the closest points, each place once
 * (mesh/surface_touch.h), and writes direction and distance where the kernels read them. A
 * contact that goes on over a border between patches takes its history along.
 */

#include "step/near.h"

/** Forget the lists of a part. */
void clod_touch_begin(clod_touch_part *self);

/** Note a near candidate, in their order, with the facets near its grain. */
void clod_touch_add(const clod_near_job *job, int part, const clod_wall_candidate *candidate);

/** Rows for the lanes of all parts; false without memory. */
bool clod_touch_layout(clod_near *near);

/** The next lane of a part has its place; its row. */
int32_t clod_touch_place(clod_near *near, int part, size_t block, int lane);

/**
 * Find the closest points for the grains of a part, and bring histories to their lanes.
 *
 * Errors  none.   Threads  one per part.   Test  tests/sim/test_sim_mesh.c
 */
void clod_touch_find(clod_near *near, const clod_state *state, const clod_wall_rows *walls,
                     int part);

void clod_touch_fini(clod_touch *self, int parts);
