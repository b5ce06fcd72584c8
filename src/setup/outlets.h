#pragma once
/**
 * @file outlets.h
 * Outlets that are walls: their shapes know it (clod_shape.outlet).
 */

#include "clod/case.h"
#include "state/walls.h"

/**
 * Note for each shape which outlet it is.
 *
 * @param walls  [in,out] all walls of the case
 * Errors  CLOD_USAGE: no mesh of the wall has the part; a surface is two outlets.
 * Threads pure.   Test  tests/cli/test_outlet_walls.py
 */
bool clod_setup_outlets(const clod_case *from, clod_walls *walls, clod_status *status);
