#pragma once
/**
 * @file part_means.h
 * Means of columns of a part's series over its steady time: the last third of the phase with which
 * the part ends. How long that phase lasts nobody knows before its end, so they are taken from
 * the rows that are in the file.
 */

#include "output/folder.h"
#include "sim/steady_time.h"

typedef struct clod_part_means {
    int phase;               ///< number of the phase, as in the series
    clod_steady_time steady; ///< s
    long rows;               ///< of the steady time
    double *mean;            ///< [count] owned; NAN: no row has a number
    double *deviation; ///< [count] of the means of the blocks; NAN: fewer than two have one
} clod_part_means;

/**
 * Read them.
 *
 * @param self   [out] owned content (clod_part_means_fini), also after a failure
 * @param part   name of a part that is finished: PART.csv, whose first columns are time and phase
 * @param first  of the columns;  @param count  of them, which may be 0
 * Errors  CLOD_FAILED: the file is gone, damaged or cannot be read; no memory.
 * Threads safe.   Test  tests/sim/test_part_means.c, tests/python/test_part_measures.py
 */
bool clod_part_means_read(clod_part_means *self, const clod_folder *folder, const char *part,
                          size_t first, size_t count, clod_status *status);

/** Free the content; an empty one is fine. */
void clod_part_means_fini(clod_part_means *self);
