#pragma once
/**
 * @file team.h
 * The threads of a step, at work together.
 */

#include "step/step.h"

/**
 * Let every thread of the step do `work`, with its number; they may meet at self->barrier. One
 * thread does all of it, as the only one, when the run-time library gives fewer.
 *
 * Errors  none.   Threads  one caller per step.   Test  tests/step/test_same_bits.c
 */
void clod_team_run(clod_step *self, void (*work)(clod_step *self, int part));
