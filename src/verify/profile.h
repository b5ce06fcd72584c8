#pragma once
/**
 * @file profile.h
 * The slope of a heap that is the same all along y: heights of its surface in columns, and the
 * line through them.
 */

#include <stddef.h>

#define CLOD_VERIFY_COLUMNS 64

/** Where the surface is looked for; columns of one width along x, and as wide along y. */
typedef struct clod_verify_profile {
    double begin; ///< m, x of the first column's edge
    double width; ///< m, of a column
    double depth; ///< m, of the heap along y, from y = 0
    size_t count; ///< columns, at most CLOD_VERIFY_COLUMNS
    // found
    double x[CLOD_VERIFY_COLUMNS];      ///< m, middle of each
    double height[CLOD_VERIFY_COLUMNS]; ///< m, mean over y of the highest point of any grain
} clod_verify_profile;

/**
 * Find the surface.
 *
 * @param self   begin, width, depth and count are given
 * @param place  [count] x, y, z, radius [m]; y within one depth of the heap is folded back
 * Errors  none.   Threads  pure.   Test  tests/verify/test_profile.c
 */
void clod_verify_profile_find(clod_verify_profile *self, const double (*place)[4],
                              size_t count);

/**
 * Angle of the slope that falls along x, by regression over the first columns, as many as are
 * at least `least` high without a gap.
 *
 * @param least  m
 * @param error  [out] standard error, from the scatter about the line [deg]
 * @return       degrees; NAN with fewer than four columns
 * Errors  none.   Threads  pure.   Test  tests/verify/test_profile.c
 */
double clod_verify_profile_angle(const clod_verify_profile *self, double least, double *error);
