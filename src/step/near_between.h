#pragma once
/**
 * @file near_between.h
 * Which shares of contacts between two parts each part takes, and in which order.
 */

#include "step/near.h"

/** Room for the contacts between parts, once all groups have their blocks; false without. */
bool clod_near_between_reserve(clod_near *self);

/**
 * Number the contacts between parts after the blocks have been filled.
 *
 * @param sort, scratch  room for as many items as there are such contacts
 */
void clod_near_between_make(clod_near *self, clod_sort_item *sort, clod_sort_item *scratch);

/** Add to the loads what the grains of a part get as i (later), or as j (not later), of a law's
 *  contacts with other parts. */
void clod_near_between_add(const clod_near *self, int part, int32_t law, bool as_i,
                           double (*load)[8]);
