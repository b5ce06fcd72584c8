#pragma once
/**
 * @file build_up.h
 * Mass that rests on walls and on the named parts of their meshes, and how it grows: a measure
 * of free runs (docs/clumps.md). It is sampled at every row of the series.
 */

#include "sim/free_measures.h"

/** Parts of meshes whose mass is reported, of all walls together; those beyond are not. */
#define CLOD_BUILD_UP_PARTS 64
/** Points of the steady time that are kept; every second one goes when there is no room. */
#define CLOD_BUILD_UP_POINTS 128

/**
 * Slope of mass over time by least squares [kg/s]; NAN with fewer than 3 points.
 *
 * @param time, mass  [count] ascending times [s], kg
 * Threads  pure.   Test  tests/measure/test_resting.c
 */
double clod_build_up_rate(const double *time, const double *mass, int64_t count);

extern const clod_free_measure CLOD_MEASURE_BUILD_UP;
