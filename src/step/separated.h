#pragma once
/**
 * @file separated.h
 * Contacts whose grains are far from what they touched one step before.
 */

#include "step/neighbour.h"

/**
 * The first contact of some grains that is not among their candidates, pairs before walls.
 *
 * @param pairs   of these grains, with the end of the last one's at the count
 * @param walls   of these grains, or of more
 * @param state   its contacts ascend
 * @param grains  rows
 * @return        its place in the list; the number of all contacts if there is none
 * Errors  none.   Threads  pure.   Test  tests/step/test_search_parts.c
 */
size_t clod_separated_first(const clod_pairs *pairs, const clod_wall_candidates *walls,
                            const clod_state *state, clod_chunk grains);
