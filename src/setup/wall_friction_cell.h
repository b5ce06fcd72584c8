#pragma once
/**
 * @file wall_friction_cell.h
 * The cell of the wall friction tester (docs/theory/wall-friction.md) with its loose grains: a
 * specimen between side walls and lid, on a plate of the wall's material.
 */

#include "clod/case.h"
#include "setup/amount.h"
#include "state/state.h"

/** The cell's walls, in this order. */
typedef enum clod_wall_friction_cell_wall {
    CLOD_WALL_FRICTION_CELL_PLATE, ///< at z = 0, flat; ring: turns about z; straight: along x
    CLOD_WALL_FRICTION_CELL_SIDES, ///< ring: inner and outer cylinder; straight: one. At rest
    CLOD_WALL_FRICTION_CELL_LID,   ///< ring: with bars; free along z under its load
    CLOD_WALL_FRICTION_CELL_WALLS,
} clod_wall_friction_cell_wall;

/**
 * What the case asks for: a number of grains, or the solid volume that fills the cell.
 * @param sizes  [out] of the grains, borrowed by the amount; owns no memory
 */
bool clod_wall_friction_cell_amount(const clod_case *from, clod_sizes *sizes,
                                    clod_amount *amount, clod_status *status);

/**
 * Build the cell at rest, filled with a loose column of grains, the lid hanging above them.
 *
 * The sides reach up to the lid and do not move with the plate: the solid and they rest, so
 * that it slips on the plate alone. The lid has its mass, area and damping, its load is of kind
 * CLOD_LOAD_STRESS with no force yet. Time step, gravity and domain are set; adhesion is
 * fill_adhesion.
 *
 * @param seed   of sizes and positions; repeats use seed, seed + 1, ...
 * @param state  [out] owned by the caller (clod_state_fini), also after a failure
 * Errors  CLOD_USAGE: a cell that cannot be built or filled.   Threads  pure.
 * Test    tests/setup/test_setup_wall_friction_cell.c
 */
bool clod_setup_wall_friction_cell(const clod_case *from, int64_t seed, clod_state *state,
                                   clod_status *status);
