#pragma once
/**
 * @file derived.h
 * What a step derives from the grains and walls that there are: radii and skins, rows of walls,
 * lists, and what the kernels read. Made when a step begins, and when grains or walls change.
 */

#include "step/step.h"

/** Radii, skins, padding, rows of walls; false: no memory, or a period that is too short. */
bool clod_step_derive(clod_step *self, clod_status *status);

/**
 * Both lists, and what kernels read.
 *
 * @param sort  also sort the grains: a rebuild; else they are as at their last one
 */
bool clod_step_build_lists(clod_step *self, bool sort, clod_status *status);

/** Rows, sums and periods for the kernels, as they lie in memory now. */
void clod_step_set_view(clod_step *self);

/** Speed of the fastest grain, or of the fastest point of a wall [m/s]. */
double clod_step_fastest(const clod_state *state);
