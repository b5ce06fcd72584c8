#pragma once
/**
 * @file sphere_grid.h
 * Cells that tell which spheres are near a position. A sphere is noted in every cell it
 * touches, by its number, so that large and small spheres mix well.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"

/** No sphere, and no cell. */
#define CLOD_SPHERE_NONE UINT32_MAX

/** Spheres that a cell has room for itself. */
#define CLOD_SPHERE_NOTES 7

/** The spheres that touch a cell; those that have no room there are in another, behind the cells of space.
 *  Half a cache line: what is asked most waits for memory. */
typedef struct clod_sphere_cell {
    uint32_t sphere[CLOD_SPHERE_NOTES]; ///< the first ones; CLOD_SPHERE_NONE behind them
    uint32_t more;                      ///< CLOD_SPHERE_NONE: none
} clod_sphere_cell;

/** A sphere that has got its place. */
typedef struct clod_placed_sphere {
    double place[4]; ///< m, centre and radius
    uint64_t number;
} clod_placed_sphere;

typedef struct clod_sphere_grid {
    double low[3], high[3]; ///< m; spheres beyond are noted in the cells of the border
    double period[3];       ///< m; 0 where space is open
    double largest;         ///< m, radius of the largest sphere that is asked about
    double inverse[3];      ///< cells per metre
    int32_t cells[3];
    clod_sphere_cell *cell; ///< [cell_count] those of space, x first, and others; owned
    size_t cell_count, cell_capacity;
    double (*sphere)[4]; ///< [sphere_count] centre and radius, with images [m]; owned
    uint32_t *number;    ///< [sphere_count] how many were added before it or its image; owned
    size_t sphere_count, sphere_capacity, number_capacity;
    size_t added; ///< spheres
} clod_sphere_grid;

/**
 * An empty grid.
 *
 * @param self       [in,out] zero, or a grid that is not needed any more, whose memory is used again
 * @param low, high  [3] bounding box of the positions that will be looked at [m]
 * @param period     [3] m; 0 where space is open
 * @param largest    radius of the largest sphere that will be asked about [m]
 * @param spheres    how many are expected: about one cell each
 */
bool clod_sphere_grid_begin(clod_sphere_grid *self, const double low[3], const double high[3],
                            const double period[3], double largest, size_t spheres,
                            clod_status *status);

/** Whether a sphere overlaps none of those noted, nor their periodic images. */
bool clod_sphere_grid_clear(const clod_sphere_grid *self, const double place[4]);

/**
 * Largest overlap of a sphere with those noted [m]; 0 when there is none.
 * @param sphere  [out] which one it is, in the order of adding
 */
double clod_sphere_grid_overlap(const clod_sphere_grid *self, const double place[4],
                                size_t *sphere);

/** Note a sphere and its periodic images; itself, if it is in the box, first of them in `sphere`. */
bool clod_sphere_grid_add(clod_sphere_grid *self, const double place[4], clod_status *status);

void clod_sphere_grid_fini(clod_sphere_grid *self);
