#pragma once
/**
 * @file cell_count.h
 * Cells of one edge along a length.
 */

#include <math.h>

/** At least 1; a rounding beyond a whole number is none. A number that cannot overflow. Threads
 *  pure. */
static inline double clod_cell_count(double length, double cell)
{
    return fmax(1.0, ceil(length / cell * (1.0 - 1e-12)));
}
