#pragma once
/**
 * @file passages.h
 * Grains that pass the planes of a state (state/planes.h) as they drift. Up to 64 rows are looked at
 * together, and only when one of them can have come to a plane since the last look.
 */

#include <stddef.h>

#include "state/state.h"

/** Most rows that are looked at together. */
#define CLOD_PASSAGE_ROWS 64

/** What is known of some rows and a plane since they were last looked at. */
typedef struct clod_passage {
    double way;   ///< m, no more than the least that a row has still to go to the plane
    uint64_t odd; ///< by row: whether its level (clod_plane_level) was odd then
} clod_passage;

/**
 * Look at rows for the first time: after a list is made, which sorts them.
 *
 * @param seen   [planes.count] [out]
 * @param first  row;  @param rows  up to CLOD_PASSAGE_ROWS
 * Errors  none.   Threads  each with its own rows.
 */
void clod_passages_note(clod_passage *seen, const clod_state *state, size_t first, size_t rows);

/**
 * After a drift: count the rows that have passed planes in it. A grain goes less than a period of the domain in a step.
 * Where it passes is on the straight line that it has gone.
 *
 * @param passed  [planes.count] [in,out] of this thread
 * @param seen    [planes.count] [in,out] of these rows
 * @param speed   m/s, of the fastest of them in the drift
 * @param first   row;  @param rows  as noted
 * Errors  none.   Threads  each with its own rows and sums.
 * Source  docs/adr/0047   Test  tests/step/test_passages.c
 */
void clod_passages_count(clod_passed *passed, clod_passage *seen, const clod_state *state,
                         double speed, size_t first, size_t rows);

/** Add sums [count] of the same planes. */
void clod_passages_merge(clod_passed *into, const clod_passed *from, int32_t count);
