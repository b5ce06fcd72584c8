#pragma once
/**
 * @file lines.h
 * The lines of a design that the chart and the page draw, in SI units.
 */

#include "hopper/result.h"

#define CLOD_LINES_MOST 61 ///< points of a line

typedef struct clod_line {
    double x[CLOD_LINES_MOST], y[CLOD_LINES_MOST];
    size_t count;
} clod_line;

/** Stress up to which the flow function is drawn: past the critical states and the points near them, and
 *  to the last point where that less than doubles it or there is no critical state. Threads  pure. */
double clod_lines_reach(const clod_hopper *self);

/** A measured property over the stress from 0 to `most`. */
void clod_lines_curve(const clod_curve *curve, double most, clod_line *line);

/** Limit of mass flow in a cone: half angle over wall friction angle, at the effective angle of the
 *  design state of the cone. */
void clod_lines_limit(const clod_hopper *self, clod_line *line);
