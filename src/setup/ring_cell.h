#pragma once
/**
 * @file ring_cell.h
 * The cell of the Schulze ring shear tester (docs/theory/ring-shear.md) with its loose grains.
 */

#include "clod/case.h"
#include "setup/amount.h"
#include "state/state.h"

/** The cell's walls, in this order. All turn about z through the origin. */
typedef enum clod_ring_cell_wall {
    CLOD_RING_CELL_TROUGH, ///< base at z = 0 with bars standing on it
    CLOD_RING_CELL_SIDES,  ///< inner and outer cylinder; they turn with the trough
    CLOD_RING_CELL_LID,    ///< ring with bars hanging below it; free along z under its load
    CLOD_RING_CELL_WALLS,
} clod_ring_cell_wall;

/** Area of the ring, pi (ro^2 - ri^2) [m2]. */
double clod_ring_cell_area(const clod_case_ring_shear *cell);

/**
 * What the case asks for: a number of grains, or the solid volume that fills the cell.
 * @param sizes  [out] of the grains, borrowed by the amount; owns no memory
 */
bool clod_ring_cell_amount(const clod_case *from, clod_sizes *sizes, clod_amount *amount,
                           clod_status *status);

/** Number of grains of the cell, from the case or from depth, fill_fraction and bars. */
size_t clod_ring_cell_count(const clod_case *from, int64_t seed, clod_status *status);

/**
 * Build the cell at rest, filled with a loose column of grains, the lid hanging above them.
 *
 * Grains are at random positions from the base up, clear of the bars; the lid's bars end above
 * the highest grain and the sides reach up to the lid. The lid has its mass, area and damping,
 * its load is of kind CLOD_LOAD_STRESS with no force yet, and nothing turns. Time step, gravity
 * and domain are set; adhesion is fill_adhesion.
 *
 * @param seed   of sizes and positions; repeats use seed, seed + 1, ...
 * @param state  [out] owned by the caller (clod_state_fini), also after a failure
 * Errors  CLOD_USAGE: a cell that cannot be built or filled.   Threads  pure.
 * Test    tests/setup/test_setup_ring_cell.c
 */
bool clod_setup_ring_cell(const clod_case *from, int64_t seed, clod_state *state,
                          clod_status *status);
