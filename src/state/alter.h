#pragma once
/**
 * @file alter.h
 * Take grains and walls out of a state's data, or put walls in. Only the step does this, at a
 * rebuild (step/change.c): everything else that knows rows must be made anew after it.
 */

#include "state/state.h"

/**
 * Take grains out; the order of the others and of their contacts stays.
 *
 * @param rank  [grains] the new row of each grain, ascending without gaps; -1: it goes
 * Errors  none.   Threads  pure.   Test  tests/step/test_change.c
 */
void clod_state_drop_grains(clod_state *self, const int32_t *rank);

/** Take a wall out, with its contacts. */
void clod_state_drop_wall(clod_state *self, int32_t wall);

/** Put walls behind the others; their shapes are taken over. False without memory. */
bool clod_state_add_walls(clod_state *self, clod_wall *walls, size_t count,
                          clod_status *status);

/**
 * Forget contacts for which `keep` is 0; the order of the others stays.
 *
 * @param keep  [contact_count]
 */
void clod_state_drop_contacts(clod_state *self, const uint8_t *keep);
