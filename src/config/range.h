#pragma once
/**
 * @file range.h
 * Numbers of a struct against the rows of its table, where no file was read.
 */

#include "clod/status.h"
#include "config/param.h"

/**
 * Whether all numbers of a struct, and of the sections in it that are used, are in the ranges of
 * their rows. Zero stands for what may be left out; lists, maps and rules between keys are not
 * looked at.
 *
 * @param self    struct of the table
 * @param what    for the message: "clod_sim_add_wall: the wall 'lid'"
 * Errors  CLOD_USAGE: the first number that is wrong, by its key.   Threads  pure.
 * Test    tests/sim/test_sim_wall_loads.c
 */
bool clod_range_holds(const clod_table *table, const void *self, const char *what,
                      clod_status *status);
