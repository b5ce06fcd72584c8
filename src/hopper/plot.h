#pragma once
/**
 * @file plot.h
 * A panel with axes in an SVG file: lines, marks and words at places in the units of its axes.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/** A panel; x and y begin at 0. */
typedef struct clod_plot {
    FILE *out;
    double left, top, width, height; ///< pixels
    double most_x, most_y;           ///< ends of the axes, in their units
} clod_plot;

/** A place in the units of the axes. */
typedef struct clod_plot_point {
    double x, y;
} clod_plot_point;

/** How a line is drawn. */
typedef struct clod_plot_pen {
    const char *colour;
    double width;
    bool dashed;
} clod_plot_pen;

/** A round number at or above x > 0, for the end of an axis. */
double clod_plot_round_up(double x);

/** Begin a picture of a size in pixels. */
void clod_plot_begin(FILE *out, int width, int height, const char *title);

void clod_plot_end(FILE *out);

/** Draw frame, ticks with numbers, and titles of the axes. */
void clod_plot_axes(const clod_plot *self, const char *x, const char *y);

/** A line through points; what lies outside the panel is cut off. */
void clod_plot_line(const clod_plot *self, const clod_plot_point *point, size_t count,
                    const clod_plot_pen *pen);

/** A mark with bars from low to high through it; those without a length are left out. */
void clod_plot_mark(const clod_plot *self, clod_plot_point at, clod_plot_point low,
                    clod_plot_point high, const char *colour);

/** Words in the lower right corner. */
void clod_plot_note(const clod_plot *self, const char *text);

/** A line of the legend, number `row` from above: a colour and what it stands for. */
void clod_plot_legend(const clod_plot *self, int row, const clod_plot_pen *pen,
                      const char *text);
