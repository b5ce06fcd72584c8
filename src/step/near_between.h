#pragma once
/**
 * @file near_between.h
 * The contacts between parts: the later part computes them, the earlier one takes its shares.
 */

#include "step/near.h"

/** Room for the contacts between parts, once all groups have their blocks; false without. */
bool clod_near_between_reserve(clod_near *self);

/** Find the runs of these contacts after the blocks have been filled. */
void clod_near_between_make(clod_near *self);

/** Where the shares of the contacts of a law with earlier parts begin. */
double (*clod_near_between_shares(const clod_near *self, int later, int32_t law))[8];

/** Add to the loads what the grains of an earlier part get from one run. */
void clod_near_between_take(const clod_near *self, const clod_near_run *run, int32_t law,
                            double (*load)[8]);
