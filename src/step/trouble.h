#pragma once
/**
 * @file trouble.h
 * When physics has gone wrong: find the grain and say so.
 */

#include "step/step.h"

/** Name the grain or contact that stopped the run; returns false. */
bool clod_trouble_report(const clod_step *self, clod_status *status);
