#pragma once
/**
 * @file ridged_plate.h
 * The plate of a wall friction test with ridges: a mesh that clod makes (docs/adr/0046).
 */

#include "clod/case.h"
#include "clod/status.h"
#include "state/walls.h"

/**
 * Make the plate a sheet with straight ridges whose floor is z = 0: radial ones where the plate
 * turns, else along y, behind one another along x.
 *
 * @param plate  [in,out] its shapes become those of the sheet
 * Errors  CLOD_FAILED: memory.   Threads  safe.   Test  tests/setup/test_ridged_plate.c
 */
bool clod_setup_ridged_plate(const clod_case_wall_friction *cell, clod_wall *plate,
                             clod_status *status);
