#pragma once
/**
 * @file wall.h
 * From a wall yield locus of one or more specimens to the curve that a hopper is designed with.
 */

#include "base/warning_list.h"
#include "clod/wall_locus.h"
#include "hopper/curve.h"

/**
 * The mean of the points at each stress. Points belong together that were asked for at the same
 * wall_stress; where not all have it, those no further apart than 2 %. Of several seeds the curve
 * has a spread: how each specimen stands off along all stresses, once its own normal stress is
 * allowed for. Of points repeated without seeds it has the standard error of their mean. Points without an error
 * have the scatter of all points about their line, of three stresses or more.
 *
 * @param points    [count]
 * @param curve     [out] owned points and spread (clod_curve_fini)
 * @param warnings  what the evaluation of the locus says is added to it
 * Errors  CLOD_FAILED: memory.   Threads  pure.   Source  docs/theory/hopper.md, Intervals.
 * Test    tests/hopper/test_wall.c
 */
bool clod_wall_curve(const clod_wall_locus_point *points, size_t count, clod_curve *curve,
                     clod_warning_list *warnings, clod_status *status);

/** Read a table and make its curve. Errors  as clod_wall_locus_read, and clod_wall_curve. */
bool clod_wall_read(const char *path, clod_curve *curve, clod_warning_list *warnings,
                    clod_status *status);
