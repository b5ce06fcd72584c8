#pragma once
/**
 * @file walk.h
 * All rows of all parameter tables, in the order of the manual.
 */

#include "config/param.h"

#define CLOD_WALK_PATH 160

/** One row and where it stands: lists and maps give a step N, NAME or PAIR to the path. */
typedef void (*clod_walk_visit)(void *context, const char *path, const clod_param *param);

/** Visit every row below a table, groups before what they hold. */
void clod_walk(const clod_table *table, clod_walk_visit visit, void *context);

/** The step that stands for one element of a group: "N", "NAME", "PAIR", or NULL. */
const char *clod_walk_step(const clod_param *param);
