#pragma once
/**
 * @file insertion_space.h
 * Where a grain may be put: inside a region, clear of walls, clear of other grains.
 */

#include "geometry/sphere_grid.h"
#include "geometry/wall_rows.h"
#include "setup/pieces.h"
#include "state/state.h"

typedef struct clod_insertion_space {
    const clod_case_region *region; ///< borrowed
    const clod_state *state;        ///< borrowed: its walls and the grains there before
    double low[3], high[3];         ///< m, bounding box of the region
    bool through[3];                ///< the region goes through a whole period
    bool face;                      ///< the region is a face: grains are whole before it
    double axis[3][3], half[2];     ///< of a face (clod_region_axes, clod_region_half)
    double largest;                 ///< m, radius of the largest grain that will be put
    size_t before;                  ///< rows of the state that were there before
    size_t *row;                    ///< [rows] those of them that reach into the block; owned
    size_t rows, row_capacity;
    clod_setup_places others;  ///< of `pieces`, that reach into it
    clod_setup_pieces *pieces; ///< has other grains that were there; NULL: nobody has
    clod_wall_rows walls;      ///< where they are
    clod_sphere_grid grid;
} clod_insertion_space;

/**
 * Get a region ready but for its grid; then a block of bands of it, and a band.
 *
 * @param top, largest  as below
 */
bool clod_insertion_space_open(clod_insertion_space *self, const clod_case_region *region,
                               double top, const clod_state *state, double largest,
                               clod_status *status);

/**
 * Collect the grains that were there before and reach into a block of bands: not for each band, since all
 * are looked at.
 *
 * @param bottom, top  m, where the centres of its grains are
 */
bool clod_insertion_space_block(clod_insertion_space *self, double bottom, double top,
                                clod_status *status);

/**
 * Look at a band of the block from now on, with all grains that were there before noted. Others, of
 * a band before, are forgotten.
 *
 * @param bottom, top  m, where the centres of its grains are
 * @param grains       that will be put, about
 */
bool clod_insertion_space_band(clod_insertion_space *self, double bottom, double top,
                               size_t grains, clod_status *status);

/**
 * Get a region ready, with all grains that are in the state noted.
 *
 * @param top      m; upper end of the region, for one that is open upwards
 * @param largest  radius of the largest grain that will be put [m]
 * @param grains   how many will be put
 */
bool clod_insertion_space_init(clod_insertion_space *self, const clod_case_region *region,
                               double top, const clod_state *state, double largest,
                               size_t grains, clod_status *status);

/** Volume of the region [m3]. */
double clod_insertion_space_volume(const clod_insertion_space *self);

/** Whether a sphere is inside the region and overlaps neither wall nor grain. */
bool clod_insertion_space_clear(const clod_insertion_space *self, const double place[4]);

/** Whether a sphere is inside the region and overlaps no wall; grains do not matter. */
bool clod_insertion_space_open_at(const clod_insertion_space *self, const double place[4]);

/** Note that a sphere has been put. */
bool clod_insertion_space_take(clod_insertion_space *self, const double place[4],
                               clod_status *status);

/**
 * A random position for a sphere in the region between two heights, uniform in volume.
 *
 * @param place   [in,out] place[3] is the radius [m]; the centre is written
 * @param bottom, top  m, between which the whole sphere is
 * @param u       [3] uniform random numbers
 * @return        false when the sphere is too large for the region
 */
bool clod_insertion_space_draw(const clod_insertion_space *self, double place[4], double bottom,
                               double top, const double u[3]);

void clod_insertion_space_fini(clod_insertion_space *self);
