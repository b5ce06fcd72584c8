#pragma once
/**
 * @file surface.h
 * Meshes of a case, made into surfaces.
 */

#include "clod/case.h"
#include "mesh/surface.h"
#include "setup/belt.h"
#include "state/walls.h"

/** The surface of a shape, and what its parts are made of. */
typedef struct clod_setup_mesh {
    clod_surface *surface;           ///< NULL: failed
    const clod_case_surface **parts; ///< [parts of the file] of the case; NULL: the shape's
    clod_setup_belt belt;            ///< what parts of a belt are
} clod_setup_mesh;

/**
 * Read the mesh of a shape, or make that of a belt, and place it: as the shape says, and then as
 * its wall does.
 *
 * @return  clod_setup_mesh_fini
 * Errors   no surface; CLOD_USAGE: the file or a part that it has not, with what to do;
 *          CLOD_FAILED: disk, memory.
 * Threads  safe.   Test  tests/sim/test_sim_mesh.c, tests/sim/test_sim_parts.c
 */
clod_setup_mesh clod_setup_mesh_read(const clod_case_wall *wall, const clod_case_shape *shape,
                                     clod_status *status);

/** Give up the surface and the list. */
void clod_setup_mesh_fini(clod_setup_mesh *self);

/**
 * Make a shape a contact that a grain can have with a patch of a surface.
 *
 * @param surface  gets one more user
 * @param slot     which of them, below CLOD_SURFACE_SLOTS
 * @param shape    [in,out] material and belt stay
 */
void clod_setup_surface_shape(clod_surface *surface, int32_t patch, int32_t slot,
                              clod_shape *shape);
