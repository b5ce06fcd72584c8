#pragma once
/**
 * @file case_measures.h
 * What a free run of a checked case measures in regions of space: fields (case.h).
 */

#include "clod/case_grains.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Density, velocity, stress and more on a grid, or their means over a region (docs/fields.md). */
typedef struct clod_case_field {
    char *name;
    clod_case_region region;
    double cell;     ///< m, edge of a cell of the grid; 0: one mean over the region
    double width;    ///< m, radius of the kernel of a grid
    double interval; ///< s of simulated time from one sample to the next
} clod_case_field;

/** Most fields. */
#define CLOD_CASE_FIELDS 16
/** Most cells of all grids of a case. */
#define CLOD_CASE_FIELD_CELLS 100000
/** Most cells of a width: a grain reaches so many in each direction. */
#define CLOD_CASE_FIELD_REACH 8.0

#ifdef __cplusplus
}
#endif
