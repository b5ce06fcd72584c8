#pragma once
/**
 * @file reorder.h
 * A new order of grains at a rebuild, by all threads: contacts go from the blocks of the old
 * near list straight to where they stand in the new order. The same as clod_near_gather and
 * clod_neighbour_sort, one after the other.
 *
 * After clod_neighbour_order: begin by one thread, count by all parts, room by one, copy by
 * all, ascend by all; each when the one before is done by all.
 *
 * Threads  parts at the same time.   Test  tests/step/test_reorder.c, test_same_bits.c
 */

#include "step/near.h"

/** No contacts counted yet. */
void clod_reorder_begin(clod_neighbour *self, size_t grains);

/** Count a part's contacts by their earlier grain in the new order. */
void clod_reorder_count(clod_neighbour *self, const clod_near *near, int part);

/** Where each grain's contacts begin, and room for all; false without memory. */
bool clod_reorder_room(clod_neighbour *self, const clod_near *near, clod_state *state,
                       clod_status *status);

/** Copy a part's contacts to their grains, in any order; the blocks' memory is given back. */
void clod_reorder_copy(clod_neighbour *self, const clod_near *near, clod_state *state,
                       const clod_wall_rows *walls, int part);

/** Put the contacts of each grain of a chunk into ascending order. */
void clod_reorder_ascend(const clod_neighbour *self, clod_state *state, clod_chunk grains);
