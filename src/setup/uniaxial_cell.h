#pragma once
/**
 * @file uniaxial_cell.h
 * The mould of the uniaxial test with its loose grains.
 */

#include "clod/case.h"
#include "setup/amount.h"
#include "state/state.h"

/** The cell's walls, in this order. */
typedef enum clod_uniaxial_cell_wall {
    CLOD_UNIAXIAL_CELL_BASE,  ///< a pan at z = 0, wider than the mould: rubble stays on it
    CLOD_UNIAXIAL_CELL_MOULD, ///< cylinder that stands on the base
    CLOD_UNIAXIAL_CELL_LID,   ///< disc of the mould's diameter; free along z under its load
    CLOD_UNIAXIAL_CELL_WALLS,
} clod_uniaxial_cell_wall;

/** Area of the mould [m2]. */
double clod_uniaxial_cell_area(const clod_case_uniaxial *cell);

/**
 * What the case asks for: a number of grains, or the solid volume that fills the cell.
 * @param sizes  [out] of the grains, borrowed by the amount; owns no memory
 */
bool clod_uniaxial_cell_amount(const clod_case *from, clod_sizes *sizes, clod_amount *amount,
                               clod_status *status);

/** Number of grains, from the case or from height and fill_fraction. */
size_t clod_uniaxial_cell_count(const clod_case *from, int64_t seed, clod_status *status);

/**
 * Build the cell at rest, filled with a loose column of grains, the lid hanging above them.
 *
 * The mould reaches up to the lid. The lid has its mass, area and damping, its load is of kind
 * CLOD_LOAD_STRESS with no force yet. Time step, gravity and domain are set; adhesion is
 * fill_adhesion.
 *
 * @param seed   of sizes and positions
 * @param state  [out] owned by the caller (clod_state_fini), also after a failure
 * Errors  CLOD_USAGE: a mould that cannot be filled.   Threads  pure.
 * Test    tests/setup/test_setup_uniaxial_cell.c
 */
bool clod_setup_uniaxial_cell(const clod_case *from, int64_t seed, clod_state *state,
                              clod_status *status);
