#pragma once
/**
 * @file region.h
 * Where the regions of a case are.
 */

#include <stdbool.h>

#include "clod/case.h"

/** Box around a region [m]. Threads: pure. */
void clod_region_bounds(const clod_case_region *self, double low[3], double high[3]);

/**
 * Whether two regions have space in common: exact for two boxes and for two annuli about one
 * axis, by the boxes around them otherwise. Regions that only touch have none.
 *
 * Threads  pure.   Test  tests/config/test_region.c
 */
bool clod_region_overlap(const clod_case_region *a, const clod_case_region *b);
