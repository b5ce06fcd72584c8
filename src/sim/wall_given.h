#pragma once
/**
 * @file wall_given.h
 * A wall that a program gives as a struct: what the tables of a case ask of its motion.
 */

#include <stdbool.h>

#include "clod/case_walls.h"
#include "clod/status.h"

/** The wall with the directions of a case that does not say, where they are zero; borrows. */
clod_case_wall clod_wall_given_directions(const clod_case_wall *wall);

/**
 * Whether a case could have its numbers: those of its motion, its load if it has one, and its
 * oscillation if it has one, in the ranges of their keys; an oscillation that moves the wall, and
 * across the axis of its load.
 *
 * @param wall      with its directions
 * @param function  for the message
 * Errors  CLOD_USAGE.   Threads  pure.   Test  tests/sim/test_sim_wall_loads.c
 */
bool clod_wall_given_holds(const clod_case_wall *wall, const char *function,
                           clod_status *status);
