#pragma once
/**
 * @file free_paths.h
 * Paths of the numbers that a measure puts into summary.json, listed before there is a run.
 */

#include <stdbool.h>
#include <stddef.h>

/** One path: names with points between; [0-2] is any place of a list from 0 to 2. */
typedef struct clod_free_path {
    char *text; ///< owned: "repose.heap.angle_deg"
    const char
        *words; ///< where the names begin that are clod's and not the case's: "angle_deg"
} clod_free_path;

/** All paths of a summary. */
typedef struct clod_free_paths {
    clod_free_path *path; ///< [count] owned
    size_t count, room;
    const char *key; ///< of the object that they are in; NULL: at the top
    bool lost;       ///< there was no memory for one
} clod_free_paths;

/**
 * Add the words of a list as paths below an object.
 *
 * @param before  names before each of them, of the case or of numbers of its lists; NULL: none
 * @param list    words with single blanks between, as printf takes it: "angle_deg force_N.[0-2]"
 * Errors  `lost`.   Threads  pure.   Test  tests/calibrate/test_number_path.c
 */
__attribute__((format(printf, 3, 4))) void
clod_free_paths_add(clod_free_paths *self, const char *before, const char *list, ...);

/** The list is empty again. */
void clod_free_paths_fini(clod_free_paths *self);
