#pragma once
/**
 * @file grid.h
 * Boxes of a case that are cut into cells.
 */

/** Cells of a box [m], as a number that cannot overflow. Threads: pure. */
double clod_grid_cells(const double low[3], const double high[3], double cell);
