#pragma once
/**
 * @file cell_part.h
 * What the cells of the testers are built of: upright walls about the z axis, and their
 * filling.
 */

#include "clod/case.h"
#include "config/sizes.h"
#include "state/state.h"

/** The state of a cell before it has walls or grains.
 *  @param adhesion  fraction of k_adh while it is filled */
void clod_cell_part_begin(const clod_case *from, double adhesion, clod_state *state);

/** Room for the walls of a cell; their shapes come with clod_cell_part_wall. */
bool clod_cell_part_walls(clod_state *state, int32_t count, clod_status *status);

/**
 * A wall of the cell, at rest, with room for its shapes.
 *
 * @param material  a name that the case has (checked at load)
 * @param wall      [out] turns about z, its load pushes down, it has no load
 */
bool clod_cell_part_wall(const clod_case *from, const char *name, const char *material,
                         int64_t shapes, clod_wall *wall, clod_status *status);

/** A flat ring, or a disc with inner 0; `facing` is 1 when grains are above, else -1. */
clod_shape clod_cell_part_ring(double inner, double outer, double height, double facing);

/** The shell of a cylinder that stands on z = 0. */
clod_shape clod_cell_part_side(double radius, double height, clod_side side);

/** Radial bars on a ring. */
typedef struct clod_cell_part_bars {
    double inner, outer;  ///< m, radii of the ring
    double radius_min;    ///< m, of the grains: a part of it is free at both ends of a bar
    int64_t count;        ///< 0: none
    double height, width; ///< m
} clod_cell_part_bars;

/** Volume of all bars [m3]. */
double clod_cell_part_bars_volume(const clod_cell_part_bars *bars);

/** A flat ring with bars on it; `facing` is 1 when grains are above, else -1.
 *  @param wall  [in,out] with room for count + 1 shapes */
void clod_cell_part_barred_ring(const clod_cell_part_bars *bars, double height, double facing,
                                clod_wall *wall);

/** A loose filling of a cell. */
typedef struct clod_cell_part_filling {
    const char *name;     ///< of the tester in messages
    const char *material; ///< of the grains
    const clod_sizes *sizes;
    int64_t seed;
    size_t count;
    double inner, outer; ///< m, radii of the cell
} clod_cell_part_filling;

/** Fill an open cell from z = 0 up; *height is the highest point of the grains [m]. */
bool clod_cell_part_fill(const clod_case *from, const clod_cell_part_filling *what,
                         clod_state *state, double *height, clod_status *status);

/** Step and damping of a cell that is complete. */
bool clod_cell_part_finish(const clod_case *from, clod_state *state, clod_status *status);
