#pragma once
/**
 * @file wall_text.h
 * One wall from a text of its own, read and checked as the wall of a case file.
 */

#include "clod/case.h"

/**
 * Read a wall.
 *
 * @param from  case whose materials the wall may be of
 * @param name  of the wall
 * @param text  YAML: what stands below the name of a wall in a case; ends with a zero byte
 * @return      owned (clod_wall_text_destroy), or NULL
 * Errors  CLOD_USAGE: all that is wrong in the text, by line and column; CLOD_FAILED: memory.
 * Threads one at a time, as clod_case_load.   Test  tests/sim/test_sim_wall_text.c
 */
clod_case_wall *clod_wall_text_read(const clod_case *from, const char *name, const char *text,
                                    clod_status *status);

/** Free a wall and null the pointer; NULL is fine. */
void clod_wall_text_destroy(clod_case_wall **self);
