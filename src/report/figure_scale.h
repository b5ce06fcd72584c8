#pragma once
/**
 * @file figure_scale.h
 * The range of an axis and its ticks, at whole multiples of 1, 2 or 5 times a power of ten.
 */

#include "report/figure.h"

typedef struct clod_figure_scale {
    double min, max; ///< in the unit of the axis
    double step;     ///< from tick to tick
    bool log;        ///< all are powers of ten of these
} clod_figure_scale;

/** The range that shows all finite numbers of a figure. @param y  of the y axis, else the x axis */
void clod_figure_scale_make(clod_figure_scale *self, const clod_figure *of, bool y);

/** Place of a value: 0 at min, 1 at max. */
double clod_figure_scale_at(const clod_figure_scale *self, double value);

int clod_figure_scale_ticks(const clod_figure_scale *self);

/** Value of tick k, and its text. */
double clod_figure_scale_tick(const clod_figure_scale *self, int k, char text[32]);
