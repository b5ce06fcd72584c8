#pragma once
/**
 * @file hopper_cells.h
 * Numbers of a design as the page shows them, rounded; the title of each is the number that the
 * design's JSON has.
 */

#include <stdio.h>

#include "hopper/fields.h"

/** Shapes in the order of the page. */
extern const int CLOD_HOPPER_CELLS_SHAPES[CLOD_HOPPER_SHAPES];

/** How the diameters of ratholes are shown. */
extern const clod_hopper_field CLOD_HOPPER_CELLS_HOLES[CLOD_HOPPER_HOLES];

/** A shape in words. */
const char *clod_hopper_cells_shape(int shape);

/** A number of SI units as people read it, without its unit; "-": not known. */
void clod_hopper_cells_text(char text[48], const clod_hopper_field *how, double value);

/** Begin an element whose title is the number as the JSON has it; no title where it has none. */
void clod_hopper_cells_begin(FILE *out, const char *tag, const clod_hopper_field *how,
                             double value);

/** A table cell. */
void clod_hopper_cells_put(FILE *out, const clod_hopper_field *how, double value);

/** The property that gives a curve (its place in clod_solid) by one value of the case; NULL: a table
 *  gives it. */
const clod_hopper_property *clod_hopper_cells_value(const clod_hopper_case *from, int curve);
