#pragma once
/**
 * @file alter.h
 * Take walls out of a state's data, or put walls in. Only the step does this, at a rebuild
 * (step/remake.c): everything else that knows walls must be made anew after it.
 */

#include "state/state.h"

/**
 * Take walls out; the order of the others stays. Contacts are the caller's affair.
 *
 * @param rank  [walls] below 0: it goes
 * Errors  none.   Threads  pure.   Test  tests/step/test_change.c
 */
void clod_state_keep_walls(clod_state *self, const int32_t *rank);

/**
 * Room for walls that come.
 *
 * Errors  false without memory; all is as before then.   Threads  pure.
 * Test    tests/sim/test_sim_memory.c
 */
bool clod_state_reserve_walls(clod_state *self, size_t count, clod_status *status);

/**
 * Put walls behind the others; their shapes are taken over.
 *
 * @param count  at most what clod_state_reserve_walls made room for
 * Errors  none.   Threads  pure.   Test  tests/step/test_change.c
 */
void clod_state_add_walls(clod_state *self, clod_wall *walls, size_t count);
