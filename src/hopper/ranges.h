#pragma once
/**
 * @file ranges.h
 * Ranges of outlets, or of ratholes, below the critical one in which none stands either: of a flow function that
 * crosses the flow factor more than once.
 */

#include "hopper/design.h"

#define CLOD_RANGES_MOST 4

/** From one outlet or diameter to another, m. */
typedef struct clod_range {
    double from, to;
} clod_range;

/** The largest first. */
typedef struct clod_ranges {
    size_t count;
    clod_range of[CLOD_RANGES_MOST];
} clod_ranges;

/**
 * Whether nothing stands at a stress [Pa].
 *
 * @param size  [out] m: the outlet or diameter that has this stress; untouched where there is none
 */
typedef bool (*clod_ranges_probe)(const void *context, double sigma_1, double *size);

/**
 * Where nothing stands, below a stress at which something does.
 *
 * @param strength  at whose points the probe may change its mind, and at most once between two of them
 * @param critical  Pa; INFINITY: at any stress beyond some one
 * Errors  none.   Threads  that of the probe.   Test  tests/hopper/test_ranges.c
 */
clod_ranges clod_ranges_find(const clod_curve *strength, double critical,
                             clod_ranges_probe is_clear, const void *context);

/**
 * Outlets of a hopper below its critical one over which no arch stands; over wider parts of the hopper above, one does.
 *
 * @param design  of which the half angle is taken
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_ranges.c
 */
clod_ranges clod_ranges_of_outlets(const clod_solid *solid, const clod_hopper_wish *wish,
                                   const clod_hopper_design *design);

/** Whether a size is in one of them. */
bool clod_ranges_hold(const clod_ranges *self, double size);
