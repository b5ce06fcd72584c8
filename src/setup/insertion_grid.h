#pragma once
/**
 * @file insertion_grid.h
 * Cells that tell which spheres are near a position. A sphere is noted in every cell it
 * touches, by its number, so that large and small spheres mix well.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"

/** A sphere, or an image of one. */
typedef struct clod_insertion_sphere {
    double place[4]; ///< centre and radius [m]
    uint32_t number; ///< how many spheres were added before it
} clod_insertion_sphere;

/** At the end of a cell's notes. */
#define CLOD_INSERTION_NONE UINT32_MAX

/** A sphere as noted in one cell. */
typedef struct clod_insertion_note {
    uint32_t sphere; ///< which of those in the grid
    uint32_t next;   ///< next note of the cell, CLOD_INSERTION_NONE at the end
} clod_insertion_note;

typedef struct clod_insertion_grid {
    double low[3], high[3]; ///< m; spheres beyond are noted in the cells of the border
    double period[3];       ///< m; 0 where space is open
    double largest;         ///< m, radius of the largest sphere that is asked about
    double inverse[3];      ///< cells per metre
    int32_t cells[3];
    uint32_t *head; ///< [cells] first note, or CLOD_INSERTION_NONE; owned
    size_t head_capacity;
    clod_insertion_note *note;     ///< [count] owned
    clod_insertion_sphere *sphere; ///< [sphere_count] with images; owned
    size_t count, capacity, sphere_count, sphere_capacity;
    size_t added; ///< spheres
} clod_insertion_grid;

/**
 * An empty grid.
 *
 * @param self       [in,out] zero, or a grid that is not needed any more, whose memory is used again
 * @param low, high  [3] bounding box of the positions that will be looked at [m]
 * @param period     [3] m; 0 where space is open
 * @param largest    radius of the largest sphere that will be asked about [m]
 * @param spheres    how many are expected: about one cell each
 */
bool clod_insertion_grid_begin(clod_insertion_grid *self, const double low[3],
                               const double high[3], const double period[3], double largest,
                               size_t spheres, clod_status *status);

/** Whether a sphere overlaps none of those noted, nor their periodic images. */
bool clod_insertion_grid_clear(const clod_insertion_grid *self, const double place[4]);

/**
 * Largest overlap of a sphere with those noted [m]; 0 when there is none.
 * @param sphere  [out] which one it is, in the order of adding
 */
double clod_insertion_grid_overlap(const clod_insertion_grid *self, const double place[4],
                                   size_t *sphere);

/** Note a sphere and its periodic images; itself, if it is in the box, first of them in `sphere`. */
bool clod_insertion_grid_add(clod_insertion_grid *self, const double place[4],
                             clod_status *status);

void clod_insertion_grid_fini(clod_insertion_grid *self);
