#pragma once
/**
 * @file repose.h
 * Angle of the surface of a heap or a slope. The surface of a cell is the top of the highest grain
 * in it, or the sphere over its middle where that is higher; it is averaged over the cells of a
 * strip: a ring about the axis of a round heap, or a strip across the direction of a slope. The
 * angle is that of the straight line through the strips of the flank.
 *
 * Source  our choice; docs/mixing.md.   Test  tests/measure/test_repose.c
 */

#include "measure/survey.h"

/** How the surface is cut. */
typedef struct clod_repose {
    clod_outlet region;
    double cell;         ///< m
    bool slope;          ///< along `direction`; else round about `center`
    double center[2];    ///< m
    double direction[2]; ///< unit, level
    double from, to;     ///< of the height: ends of the flank
} clod_repose;

/** What came of it; NAN where there is none. */
typedef struct clod_repose_angle {
    double angle;   ///< rad, positive where it falls outwards or along the direction
    double error;   ///< rad, standard error of the line
    double height;  ///< m, of the highest strip, over the region's bottom
    int64_t strips; ///< of the flank; with fewer than three there is no angle
} clod_repose_angle;

/**
 * Centre of mass of the grains in a region, seen from above.
 *
 * @param center  [out] 0 of no grain
 * Errors  CLOD_FAILED: memory on another rank.   Threads  one per bed.
 */
bool clod_repose_center(const clod_outlet *region, const clod_survey *survey, double center[2],
                        clod_status *status);

/**
 * The angle of the grains in the region, which may stand in any order.
 *
 * @param found  [out]
 * Errors  CLOD_FAILED: memory.   Threads  one per bed.
 */
bool clod_repose_find(const clod_repose *self, const clod_survey *survey,
                      clod_repose_angle *found, clod_status *status);

extern const clod_survey_way CLOD_REPOSE_WAY, CLOD_REPOSE_CENTER_WAY;
