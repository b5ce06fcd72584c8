#pragma once
/**
 * @file jenike_cell.h
 * The cell of the Jenike shear tester (docs/theory/jenike.md) with its loose grains.
 */

#include "clod/case.h"
#include "setup/amount.h"
#include "state/state.h"

/** The cell's walls, in this order. The axis of the lower two is the z axis. */
typedef enum clod_jenike_cell_wall {
    CLOD_JENIKE_CELL_BASE,       ///< floor at z = 0
    CLOD_JENIKE_CELL_BASE_RING,  ///< cylinder up to base_height, there its rim, facing up
    CLOD_JENIKE_CELL_SHEAR_RING, ///< rim facing down on it, and the cylinder above; `offset`
                                 ///< behind it along x
    CLOD_JENIKE_CELL_LID,        ///< disc in the shear ring; free along z under its load
    CLOD_JENIKE_CELL_WALLS,
} clod_jenike_cell_wall;

/** Area of the shear plane [m2]. */
double clod_jenike_cell_area(const clod_case_jenike *cell);

/**
 * What the case asks for: a number of grains, or the solid volume that fills the cell.
 * @param sizes  [out] of the grains, borrowed by the amount; owns no memory
 */
bool clod_jenike_cell_amount(const clod_case *from, clod_sizes *sizes, clod_amount *amount,
                             clod_status *status);

/** Number of grains, from the case or from the rings' heights and fill_fraction. */
size_t clod_jenike_cell_count(const clod_case *from, int64_t seed, clod_status *status);

/**
 * Build the cell at rest, filled with a loose column of grains, the lid hanging above them.
 *
 * The cylinder of the shear ring reaches up to the lid, as a mould ring on it would. The lid
 * has its mass, area and damping, its load is of kind CLOD_LOAD_STRESS with no force yet. Time
 * step, gravity and domain are set; adhesion is fill_adhesion.
 *
 * @param seed   of sizes and positions; repeats use seed, seed + 1, ...
 * @param state  [out] owned by the caller (clod_state_fini), also after a failure
 * Errors  CLOD_USAGE: a cell that cannot be filled.   Threads  pure.
 * Test    tests/setup/test_setup_jenike_cell.c
 */
bool clod_setup_jenike_cell(const clod_case *from, int64_t seed, clod_state *state,
                            clod_status *status);
