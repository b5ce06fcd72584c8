#pragma once
/**
 * @file passages.h
 * Grains that pass the planes of a state (state/planes.h) as they drift.
 */

#include <stddef.h>

#include "state/state.h"

/**
 * Count the rows that have passed planes between two positions. Where one passes is on the straight line
 * between them.
 *
 * @param passed  [planes->count] [in,out] of this thread
 * @param before  [rows] m, with the radius
 * @param first   row of the first of them, which are at the second now
 * @return        m, no more than the least way of one of them to a plane from there
 * Errors  none.   Threads  each with its own rows and sums.
 * Source  docs/adr/0047   Test  tests/step/test_passages.c
 */
double clod_passages_count(clod_passed *passed, const clod_state *state,
                           const double (*before)[4], size_t first, size_t rows);

/** Add sums [count] of the same planes. */
void clod_passages_merge(clod_passed *into, const clod_passed *from, int32_t count);
