#pragma once
/**
 * @file near_cursor.h
 * Every contact of a near list, ascending by (i, j) or by (i, shape's row), whatever the groups
 * in which they lie: in each group contacts ascend, so those of a part are merged by key.
 * What a contact is follows from its block alone. And one contact, found by its key.
 */

#include "step/near.h"

typedef struct clod_near_cursor {
    const clod_near *near;
    const clod_near_blocks *list; ///< pairs or walls
    clod_near_source *source;     ///< [sources] groups and runs of a part
    int32_t sources;
    // the contact
    const void *block; ///< clod_contact_block, or clod_wall_block of the walls' list
    int lane;
} clod_near_cursor;

/** Where a list's blocks have what the cursor needs. */
typedef struct clod_near_format {
    size_t size;    ///< bytes of a block
    size_t partner; ///< j, or the shape's row
    size_t history;
} clod_near_format;

/** Format of one of the two lists. */
clod_near_format clod_near_format_of(const clod_near *self, const clod_near_blocks *list);

/**
 * Before the first contact of a part's grains, as i; one cursor of a part at a time.
 *
 * @param list  &near->pairs or &near->walls
 */
clod_near_cursor clod_near_cursor_begin(const clod_near *near, const clod_near_blocks *list,
                                        int part);

/** Go on to the next contact that touches; false: there is none. */
bool clod_near_cursor_next(clod_near_cursor *self);

/** Rows and shape of the contact that it is at, without its history. */
void clod_near_cursor_name(const clod_near_cursor *self, const clod_wall_rows *walls,
                           clod_contact *to);

/** Copy the contact that it is at; `walls` are the rows that the list was made with. */
void clod_near_cursor_copy(const clod_near_cursor *self, const clod_wall_rows *walls,
                           clod_contact *to);

/** Give the memory of blocks that have been read back, in a large bed. */
void clod_near_cursor_release(const clod_near_cursor *self);

/**
 * Find a contact by its key.
 *
 * @param list     &near->pairs or &near->walls
 * @param i        row of the grain; of a pair the one that comes first in the order of grains
 * @param partner  row of the other grain, or of the shape (clod_wall_rows_shape)
 * @param lane     [out] where it is in the history
 * @return         its history, or NULL when they do not touch
 */
const clod_history *clod_near_find(const clod_near *self, const clod_near_blocks *list,
                                   int32_t i, int32_t partner, int *lane);
