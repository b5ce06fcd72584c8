#pragma once
/**
 * @file near_parts.h
 * The grains cut into parts, one for each thread.
 */

#include "step/near.h"

// Work by the time that it takes (docs/adr/0022).
#define CLOD_NEAR_GRAIN_WORK 1 ///< moving a grain
#define CLOD_NEAR_PAIR_WORK                                                                    \
    3 ///< a contact between two grains: of the later one, whose part computes it
#define CLOD_NEAR_WALL_WORK 4 ///< one with a wall: its gap comes on top

/** Part of a grain. */
int clod_near_part_of(const clod_near *self, int32_t grain);
