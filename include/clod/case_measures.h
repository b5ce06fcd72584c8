#pragma once
/**
 * @file case_measures.h
 * What a run of a checked case measures in regions of space: fields (case.h).
 */

#include "clod/case_grains.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Along which directions vectors and tensors of a field are told. */
typedef enum clod_components {
    CLOD_COMPONENTS_CARTESIAN,
    CLOD_COMPONENTS_CYLINDRICAL ///< r, t, z about the axis of an annulus
} clod_components;

/** Density, velocity, stress and more on a grid, or their means over a region (docs/fields.md). */
typedef struct clod_case_field {
    char *name;
    clod_case_region region;
    double cell;     ///< m, edge of a cell of the grid; 0: one mean over the region
    double width;    ///< m, radius of the kernel of a grid
    double interval; ///< s of simulated time from one sample to the next
    bool frames;     ///< of a grid: the moment of each snapshot is written too
    int components;  ///< clod_components
} clod_case_field;

/** Most fields. */
#define CLOD_CASE_FIELDS 16
/** Most cells of all grids of a case. */
#define CLOD_CASE_FIELD_CELLS 100000
/** Cells of a width: with fewer grains are missed between the middles of cells; a grain reaches so
 *  many in each direction. */
#define CLOD_CASE_FIELD_LEAST 1.5
#define CLOD_CASE_FIELD_REACH 8.0

/** What samples of a mixture are told by. */
typedef enum clod_mixing_by { CLOD_MIXING_BY_NUMBER, CLOD_MIXING_BY_MASS } clod_mixing_by;

/** How well two kinds of grains are mixed (docs/mixing.md). Exactly one of material, above tells them
 *  apart. */
typedef struct clod_case_mixing {
    char *name;
    clod_case_region region;
    double cell;    ///< m, edge of a sample
    char *material; ///< of the first kind; NULL: size tells
    double above; ///< m, radius above which grains are of the first kind; 0: the material tells
    int by;       ///< clod_mixing_by
} clod_case_mixing;

/** Angle of the surface of a heap or a slope (docs/mixing.md). */
typedef struct clod_case_repose {
    char *name;
    clod_case_region region;
    double cell; ///< m, edge of a cell of the surface
    bool has_center;
    double center[2];    ///< m, x and y of the axis of a round heap; else its centre of mass
    bool has_direction;  ///< it is a slope
    double direction[3]; ///< level, along which the slope falls; any length
    double from, to;     ///< of the height: part of the flank that counts
} clod_case_repose;

/** Most mixing indices, and angles. */
#define CLOD_CASE_MIXINGS 16
/** Most cells of one of them. */
#define CLOD_CASE_MIXING_CELLS 100000

#ifdef __cplusplus
}
#endif
