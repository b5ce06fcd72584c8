#pragma once
/**
 * @file near_parts.h
 * The grains cut into parts, one for each thread.
 */

#include "step/near.h"

/** Cut the grains into parts of about as much work; the cut changes no result. */
void clod_near_cut(clod_near *self, const clod_neighbour *neighbour, size_t grains);

/** Part of a grain. */
int clod_near_part_of(const clod_near *self, int32_t grain);
