#pragma once
/**
 * @file surface.h
 * Meshes of a case, made into surfaces.
 */

#include "clod/case.h"
#include "mesh/surface.h"

/**
 * Read the mesh of a shape and place it: as the shape says, and then as its wall does.
 *
 * @return  clod_surface_release, or NULL
 * Errors   CLOD_USAGE: the file, with what to do; CLOD_FAILED: disk, memory.
 * Threads  safe.   Test  tests/sim/test_sim_mesh.c
 */
clod_surface *clod_setup_surface(const clod_case_wall *wall, const clod_case_shape *shape,
                                 clod_status *status);
