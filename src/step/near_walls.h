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

/** Count the grains of a part that are near walls. */
void clod_near_walls_count(const clod_near_job *job, int part);

/** Room for the blocks of all parts and for forces on walls; false without memory. */
bool clod_near_walls_layout(const clod_near_job *job);

/** A part's contacts with walls into blocks, with the histories of those that touch. */
void clod_near_walls_place(const clod_near_job *job, int part);
