#pragma once
/**
 * @file wall_cells.h
 * Cells of the wall friction test: one row for each CLOD_CASE_CELL_*, and the sizes that follow
 * from it. How the plate of each is driven is in src/tester/wall_shear.c.
 */

#include "clod/case.h"

typedef struct clod_wall_cell {
    bool annulus; ///< has an inner radius, and a side wall there
    bool bars;    ///< bars of the lid hold the solid; else the lid has none
    bool turns;   ///< the plate turns about z; else it moves along x, on and on
} clod_wall_cell;

/** Names in the case file in the order of CLOD_CASE_CELL_*, ended by NULL. */
extern const char *const CLOD_WALL_CELL_NAMES[];

/** Row of the cell of a test. Threads: pure. Test tests/config/test_wall_cells.c */
const clod_wall_cell *clod_wall_cell_of(const clod_case_wall_friction *test);

/** Inner radius of the specimen [m]; 0: it has none. */
double clod_wall_cell_inner(const clod_case_wall_friction *test);

/** Width of the specimen [m]: between the side walls. */
double clod_wall_cell_width(const clod_case_wall_friction *test);

/** Area of the specimen [m2]. */
double clod_wall_cell_area(const clod_case_wall_friction *test);

/** Bars on the lid. */
int64_t clod_wall_cell_bars(const clod_case_wall_friction *test);
