#pragma once
/**
 * @file warnings_points.h
 * What is not right with the points of a yield locus, whatever line goes through them.
 */

#include "clod/locus.h"

/**
 * Add warnings of units, of stated errors, and of bulk densities that do not go together.
 *
 * @param locus   [in,out] complete but for its warnings
 * @param points  [count] it was evaluated from
 * Errors  none.   Threads  pure.   Test  tests/analysis/test_nonsense.c
 */
void clod_warnings_points_check(clod_locus *locus, const clod_locus_point *points,
                                size_t count);

/** Whether a point states an error of a shear stress as large as it; clod_warnings_points_check says so.
 *  @param points  [count]   Test  tests/analysis/test_nonsense.c */
bool clod_warnings_points_unmeasured(const clod_locus_point *points, size_t count);

/** Warn when the bulk densities of several seeds, loci[count], differ too much.
 *  @param locus  [in,out] their mean   Test  tests/analysis/test_nonsense.c */
void clod_warnings_points_check_seeds(clod_locus *locus, const clod_locus *loci, size_t count);
