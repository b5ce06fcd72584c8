#pragma once
/**
 * @file trouble.h
 * When physics has gone wrong: find the grain and say so.
 */

#include "step/step.h"

/** Numbers of walls in clod_step_trouble.id begin with it: behind all grains. */
#define CLOD_TROUBLE_WALLS (UINT64_MAX - (uint64_t)INT32_MAX)

/**
 * Note the deepest contact after a step with an overlap beyond the laws' range: the run stops one
 * step later, when all ranks know, and tells what was here. Threads: none in a step.
 */
void clod_trouble_note(clod_step *self);

/** Whether of two troubles the first is told: of the earlier step, deeper, with lower ids. */
bool clod_trouble_comes_first(const clod_step_trouble *a, const clod_step_trouble *b);

/** Tell what is noted, or name the grain or contact that is wrong now; returns false. */
bool clod_trouble_report(const clod_step *self, clod_status *status);
