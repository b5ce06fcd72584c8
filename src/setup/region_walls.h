#pragma once
/**
 * @file region_walls.h
 * Walls that reach into the regions of grains: of groups that are put, and of inlets.
 *
 * Insertion keeps grains clear of walls, behind planes, in boxes and on the wrong side of shells there are none.
 * But it puts them on both sides of a plate, a mesh or a belt. A surface that cuts off of a region less than a
 * grain is wide puts nobody behind it and is not told.
 *
 * Planes, boxes, facets: exact. Discs and annuli stand for polygons of 90 corners. Round belts are their facets.
 * Cylinders and cones are not asked: grains come on their own side alone.
 */

#include "clod/case.h"
#include "state/walls.h"

/** What is told of a region and a wall. */
typedef void (*clod_setup_regions_tell)(void *context, const char *text);

/**
 * Tell of each shape that cuts the region of a group, as walls are now.
 *
 * @param packings  of groups that are put at the start too, not only of inlets
 * Threads  pure.   Test  tests/setup/test_region_walls.c
 */
void clod_setup_regions_doubts(const clod_case *from, const clod_walls *walls, bool packings,
                               clod_setup_regions_tell tell, void *context);

/**
 * Whether grains can reach every region: none lies whole behind a plane or in a box; of an inlet only walls that stay
 * where they are count.
 *
 * Errors  CLOD_USAGE: names region and wall.   Threads  pure.   Test  tests/setup/test_region_walls.c
 */
bool clod_setup_regions_reached(const clod_case *from, const clod_walls *walls,
                                clod_status *status);
