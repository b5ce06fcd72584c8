#pragma once
/**
 * @file figure_map.h
 * Maps of colours: numbers of equal cells over a rectangle. The colours are those of the 3-D view
 * (web/view.js): lightness rises along them for any colour vision and in grey.
 */

#include <stdio.h>

#include "report/figure.h"

/** The map viridis at equal steps; straight lines in sRGB between them. */
#define CLOD_FIGURE_MAP_COLOURS 8
extern const char *const CLOD_FIGURE_MAP_COLOUR[CLOD_FIGURE_MAP_COLOURS];

#define CLOD_FIGURE_MAP_SHADES 128 ///< that an SVG tells apart

/** Where a map is drawn, in units of the drawing. */
typedef struct clod_figure_map_place {
    double left, right, top, bottom;
} clod_figure_map_place;

/**
 * Give a figure a map; its scales become equal. The colours reach from 0, or the least number below it,
 * to the greatest number: of one that is constant from 0 to it, of zeros alone to 1.
 *
 * @param map  numbers and their place, without `least` and `most`; the figure takes `number` over.
 *             NULL there: there was no memory for them, the figure is lost
 * Test    tests/report/test_figure_map.c
 */
void clod_figure_map_set(clod_figure *figure, const clod_figure_map *map);

/**
 * Give the maps of several figures the same colours: from 0, or the least number of all below it, to the
 * greatest number of all, with the exceptions above.
 *
 * @param figures  [count] with a map each
 * Test    tests/report/test_figure_map.c
 */
void clod_figure_map_share(clod_figure *figures, size_t count);

/** Number of the shade of a value, 0 to CLOD_FIGURE_MAP_SHADES - 1; -1: blank. */
int clod_figure_map_shade(const clod_figure_map *self, double value);

/** Colour of a shade, "#rrggbb". */
void clod_figure_map_colour(int shade, char text[8]);

/** Draw the cells as SVG: a path for each shade, in steps of cells from the lower left corner. */
void clod_figure_map_svg(FILE *out, const clod_figure_map *self,
                         const clod_figure_map_place *place);

/** Draw the bar right of them with its ticks. @param name  of the figure */
void clod_figure_map_bar(FILE *out, const char *name, const clod_figure_map *self,
                         const clod_figure_map_place *place);
