#pragma once
/**
 * @file region.h
 * Where the regions of a case are.
 */

#include <stdbool.h>

#include "clod/case.h"

/** Whether it is a disc or a rectangle. Threads: pure. */
static inline bool clod_region_is_face(const clod_case_region *self)
{
    return self->kind == CLOD_REGION_DISC || self->kind == CLOD_REGION_RECTANGLE;
}

/** Axes of a face: two in it, of a rectangle along its edges, and its normal; unit vectors.
 *  Threads: pure. */
void clod_region_axes(const clod_case_region *self, double axis[3][3]);

/** Half the extent of a face along its two axes in it [m]. Threads: pure. */
void clod_region_half(const clod_case_region *self, double half[2]);

/** Area across which grains come of a face, or the base of a box or annulus [m2]. Threads:
 *  pure. */
double clod_region_area(const clod_case_region *self);

/** Box around a region [m]; of a face around its depth. Threads: pure. */
void clod_region_bounds(const clod_case_region *self, double low[3], double high[3]);

/**
 * Whether two regions have space in common: exact for two boxes and for two annuli about one
 * axis, by the boxes around them otherwise. Regions that only touch have none.
 *
 * Threads  pure.   Test  tests/config/test_region.c
 */
bool clod_region_overlap(const clod_case_region *a, const clod_case_region *b);
