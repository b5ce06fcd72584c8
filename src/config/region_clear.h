#pragma once
/**
 * @file region_clear.h
 * How fast grains leave the region of an inlet, by their velocity and by gravity.
 */

#include <stdbool.h>

#include "clod/case.h"

typedef struct clod_region_clear {
    double time; ///< s, in which the region empties; HUGE_VAL: nothing leaves it
    bool
        falls_back; ///< grains thrown against gravity turn inside of it and fall back through it
    double rise;    ///< m, how far those come; 0 without
    double height;  ///< m, of the region in that direction; 0 without
    double
        enough; ///< m/s, least speed in the same direction at which none turns inside; 0 without
} clod_region_clear;

/**
 * How fast grains leave a region that is no face. Along an axis a grain needs the time T for the way h through the
 * region: h/v without gravity, (sqrt(v^2 + 2 g h) - v)/g with it, (v - sqrt(v^2 - 2 g h))/g against it; where it turns
 * inside, since v^2/(2 g) < h, (v + sqrt(2 g h))/g until it has come back and out below. What leaves by the sides across the
 * axes adds up, so 1/time is the sum of 1/T: a stream has the solid fraction volume flow times time over volume where it leaves.
 * Of an annulus h is that of the box about it.
 *
 * @param region    a box or an annulus
 * @param velocity  of the grains as they come [m/s]
 * @param gravity   m/s2
 * Threads  pure.   Source  free flight.   Test  tests/config/test_region_clear.c
 */
clod_region_clear clod_region_clear_of(const clod_case_region *region, const double velocity[3],
                                       const double gravity[3]);
