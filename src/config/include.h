#pragma once
/**
 * @file include.h
 * `include: FILE`: the keys of another file beside those of the case.
 */

#include "config/load.h"

/**
 * Merge the file that the tree names into the tree, before any override. Sections of both are joined, step
 * by step. A value that both have is an error, but for a file that --set names, whose values replace those of
 * the case as every --set does. An include in the included file is an error. The file's text lives in the
 * loader's arena.
 *
 * @param self  loader; root is the tree or NULL; errors go to its report, with the name and the line of the
 *              file they stand in
 * Test  tests/config/test_include.c
 */
void clod_include_merge(clod_loader *self);
