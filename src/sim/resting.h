#pragma once
/**
 * @file resting.h
 * Which grains rest on which wall (docs/clumps.md): those slower than a speed against the wall's
 * material that touch it, and those slower that touch such a grain, and so on.
 */

#include "state/contact_source.h"

/** Of one grain. */
typedef struct clod_resting {
    int32_t wall;  ///< that it rests on; -1: none
    int32_t shape; ///< of the wall
    int32_t steps; ///< contacts from it to the wall along the shortest way, 1 or more
} clod_resting;

/**
 * Find the wall that each grain rests on: the one with fewest contacts between; of several the
 * first, and of its shapes the first that the grain itself touches, or that of the grain with
 * the smallest id on whose side it hangs.
 *
 * @param to     [out] [grains.count] by row
 * @param speed  m/s
 * Errors  CLOD_FAILED: memory.   Threads  pure.   Test  tests/sim/test_resting.c
 */
bool clod_resting_find(clod_resting *to, const clod_state *state,
                       const clod_contact_source *contacts, double speed, clod_status *status);
