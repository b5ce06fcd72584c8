#pragma once
/**
 * @file remake.h
 * Lists made anew by all threads: the near list alone (a refresh), or everything (a rebuild):
 * grains and walls come and go, grains and contacts into a new order, candidates, near list.
 */

#include "step/step.h"

/**
 * Begin: one thread, before the others come to clod_remake_lists.
 *
 * @param again  a rebuild
 * @param speed  of the fastest grain or point of a wall now [m/s]
 */
void clod_remake_begin(clod_step *self, bool again, double speed);

/**
 * Make the lists; every thread of the step calls this. After a failure self->failed is set and
 * self->status says why.
 *
 * Errors  CLOD_FAILED: memory, a grain that left the domain; CLOD_USAGE: changes that cannot be.
 * Threads all of the step.   Test  tests/step/test_same_bits.c, test_change.c, test_leave.c
 */
void clod_remake_lists(clod_step *self, int part);
