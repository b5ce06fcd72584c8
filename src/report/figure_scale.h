#pragma once
/**
 * @file figure_scale.h
 * The range of an axis and its ticks, at whole multiples of 1, 2 or 5 times a power of ten.
 */

#include "report/figure.h"

typedef struct clod_figure_scale {
    double min, max; ///< in the unit of the axis
    double step;     ///< from tick to tick; the first is the least multiple of it in the range
    bool log;        ///< all are powers of ten of these
} clod_figure_scale;

/** The range that shows all finite numbers of a figure, from tick to tick; with a map that from edge to
 *  edge of it. @param y  of the y axis, else the x axis */
void clod_figure_scale_make(clod_figure_scale *self, const clod_figure *of, bool y);

/** The range of the colours of a map. */
void clod_figure_scale_colours(clod_figure_scale *self, const clod_figure_map *map);

/** Place of a value: 0 at min, 1 at max. */
double clod_figure_scale_at(const clod_figure_scale *self, double value);

int clod_figure_scale_ticks(const clod_figure_scale *self);

/** Every how manieth tick has `room` for its text, on an axis of this length. */
int clod_figure_scale_stride(const clod_figure_scale *self, double length, double room);

/** Value of tick k, and its text. */
double clod_figure_scale_tick(const clod_figure_scale *self, int k, char text[32]);
