#pragma once
/**
 * @file axis.h
 * The scale of a colour bar: its range, the numbers beside it, its unit with a prefix; and round
 * lengths.
 */

#include <stdbool.h>
#include <stddef.h>

#define CLOD_AXIS_TICKS 16

typedef struct clod_axis {
    double min, max;   ///< in the unit of the values
    char title[160];   ///< with the unit
    size_t tick_count; ///< at most CLOD_AXIS_TICKS
    double tick[CLOD_AXIS_TICKS];
    char text[CLOD_AXIS_TICKS][24]; ///< number beside a tick
} clod_axis;

/**
 * Choose a range for values, with round ends: of all of them but for the outermost half percent
 * at either side where these lie far out; from zero where all are positive and the smallest is
 * below a quarter of the largest; the same to both sides of zero where both signs matter.
 *
 * @param value  [count] sorted by the call; no NaN
 * Errors  none; without values 0 ... 1.   Threads  pure.   Test  tests/picture/test_axis.c
 */
void clod_axis_range(double *value, size_t count, double *min, double *max);

/** Make ticks and texts. @param units  udunits text of the values, as snapshots have it */
void clod_axis_make(clod_axis *self, double min, double max, const char *title,
                    const char *units);

/** The largest of 1, 2, 5, 10, 20 ... (and 0.5, 0.2 ...) that is not above x > 0. */
double clod_axis_round_down(double x);

/** A length in m as a text with m, mm or um. */
void clod_axis_length_text(double length, char text[32]);
