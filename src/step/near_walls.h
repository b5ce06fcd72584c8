#pragma once
/**
 * @file near_walls.h
 * The part of a near list's making that is about walls.
 */

#include "step/near.h"

/** The first block of each group from the numbers of its contacts (near.c). */
void clod_near_layout_groups(clod_near_blocks *blocks, size_t groups);

/** Room for the blocks of all groups (near.c). */
bool clod_near_reserve_blocks(clod_near_blocks *self, size_t groups, size_t size);

/** Count grains near walls; room for their blocks and for the walls' slots. */
bool clod_near_walls_layout(const clod_near_job *job);

/** All of them into blocks, before any memory of the state's contacts is given back. */
void clod_near_walls_place(const clod_near_job *job);
