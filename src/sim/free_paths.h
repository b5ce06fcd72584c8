#pragma once
/**
 * @file free_paths.h
 * Paths of the numbers that a measure puts into summary.json, listed before there is a run.
 */

#include <stdbool.h>
#include <stddef.h>

#define CLOD_FREE_PATHS_TEXT 256 ///< bytes of a path, its end among them

/** One path: names with points between, * for any place in a list, ** at its end for anything. */
typedef struct clod_free_path {
    char text[CLOD_FREE_PATHS_TEXT];
} clod_free_path;

/**
 * Take word number k of a list as a path below an object.
 *
 * @param list    words with single blanks between: "angle_deg power_W.mean"
 * @param before  name of the object; NULL: none
 * @param k       [in, out] what is left of it when the list has fewer words
 * @return        whether the list has that word
 * Errors  none.   Threads  pure.   Test  tests/calibrate/test_calibrate_paths.py
 */
bool clod_free_paths_pick(const char *list, const char *before, size_t *k,
                          clod_free_path *path);
