#pragma once
/**
 * @file include.h
 * `include: FILE`: the keys of another file beside those of the case.
 */

#include "config/load.h"

/**
 * Merge the file that the tree names into the tree, before any override. Sections of both are joined, step
 * by step; a value that both have is an error, and so is an include in the included file. The file's text
 * lives in the loader's arena.
 *
 * @param self  loader; root is the tree or NULL; errors go to its report, with the name and the line of the
 *              file they stand in
 * Test  tests/config/test_include.c
 */
void clod_include_merge(clod_loader *self);
