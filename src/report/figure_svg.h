#pragma once
/**
 * @file figure_svg.h
 * Figures as SVG, with text as text: for papers, for print, and where no script runs.
 */

#include <stdio.h>

#include "report/figure.h"

/** Write a figure as an SVG element. Test  tests/report/test_figure.c */
void clod_figure_svg(FILE *out, const clod_figure *figure);
