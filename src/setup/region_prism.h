#pragma once
/**
 * @file region_prism.h
 * A region of a case as a prism, a box or an upright ring turned into space, and what a flat polygon cuts of it.
 */

#include <stdbool.h>

#include "base/vec3.h"
#include "clod/case.h"

/** Corners of a polygon, before it is cut. */
#define CLOD_REGION_PRISM_CORNERS 4

typedef struct clod_region_prism {
    clod_vec3 middle;  ///< m
    clod_vec3 axis[3]; ///< unit
    double half[3];    ///< m, along the axes; round: half[0] is the radius
    bool round;        ///< about axis[2]
    double inner;      ///< m, radius of the hole; 0: none
} clod_region_prism;

/**
 * Where whole grains of a group can be in its region, or before its face.
 *
 * @param radius  m, of the smallest grain
 * @return        the region; of a face the way of its depth and a grain
 * Threads  pure.   Test  tests/setup/test_region_walls.c
 */
clod_region_prism clod_region_prism_make(const clod_case_region *region, double radius);

/**
 * The part of a region that is farther than `margin` [m] from its sides, or a hundredth of it from the ends of a face.
 * @return  false: there is none
 */
bool clod_region_prism_shrink(const clod_case_region *region, double margin,
                              clod_region_prism *self);

/** Half the extent of a prism along a unit vector [m]. */
double clod_region_prism_extent(const clod_region_prism *self, clod_vec3 along);

/**
 * Whether a flat convex polygon has a point in the prism: exact.
 *
 * @param corner  [count] in order [m]; count is CLOD_REGION_PRISM_CORNERS at most
 * @param at      [out] a point of the polygon in or near the prism [m]
 * Threads  pure.   Test  tests/setup/test_region_walls.c
 */
bool clod_region_prism_cut(const clod_region_prism *self, const clod_vec3 *corner, int count,
                           clod_vec3 *at);
