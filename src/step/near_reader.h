#pragma once
/**
 * @file near_reader.h
 * The contacts of a near list as they are asked for: the same, in the same order, as
 * clod_near_gather copies, without a list of all.
 */

#include "step/near_cursor.h"

typedef struct clod_near_reader {
    clod_near *near;             ///< borrowed: it must be made, and stay as it is
    const clod_wall_rows *walls; ///< borrowed: rows that it was made with
    const clod_near_blocks *list;
    int part;
    clod_near_cursor cursor; ///< along a part of one of its lists
} clod_near_reader;

/** Before the first contact; one reader of a list at a time. */
clod_near_reader clod_near_reader_begin(clod_near *near, const clod_wall_rows *walls);

/** Copy the next contacts, at most `room`; fewer only at the end. */
size_t clod_near_reader_next(clod_near_reader *self, clod_contact *to, size_t room);
