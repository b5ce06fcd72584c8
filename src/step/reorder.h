#pragma once
/**
 * @file reorder.h
 * A new order of grains at a rebuild, by all threads: contacts go from the blocks of the old
 * near list straight to where they belong in the new order. Those of grains and walls that go
 * are left behind.
 *
 * With the order that layer_order.h finds: begin by all parts, count by all, room by one thread,
 * copy by all, ascend by all; each when the one before is done by all.
 *
 * Threads  parts at the same time.   Test  tests/step/test_reorder.c, test_same_bits.c
 */

#include "step/near.h"

typedef struct clod_reorder {
    clod_neighbour *neighbour; ///< its rank has the new row of each grain
    const clod_near *near;     ///< the old list
    clod_state *state;
    const clod_wall_rows *walls; ///< the rows that the list was made with
    size_t grains;               ///< that stay
    const int32_t *wall_rank;    ///< [walls] new number, or -1: it goes; NULL: all stay
    bool moved; ///< grains or walls were put elsewhere: what does not touch now is forgotten
} clod_reorder;

/** No contacts counted yet of a part's grains. */
void clod_reorder_begin(const clod_reorder *self, int part);

/** Count a part's contacts by their earlier grain in the new order. */
void clod_reorder_count(const clod_reorder *self, int part);

/** Where each grain's contacts begin, and room for all; false without memory. */
bool clod_reorder_room(const clod_reorder *self, clod_status *status);

/** Copy a part's contacts to their grains, in any order; the blocks' memory is given back. */
void clod_reorder_copy(const clod_reorder *self, int part);

/** Put the contacts of each grain of a part into ascending order. */
void clod_reorder_ascend(const clod_reorder *self, int part);
