#pragma once
/**
 * @file flow_figure.h
 * The figure of a flow function: strength over consolidation, with Jenike's classes.
 */

#include "report/figure.h"

/** An empty figure with its axes. */
void clod_flow_figure_init(clod_figure *self);

/** Add the borders of Jenike's classes, up to this sigma_1 [Pa]. Source docs/theory/yield-locus.md */
void clod_flow_figure_classes(clod_figure *self, double largest);
