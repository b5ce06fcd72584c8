#pragma once
/**
 * @file belt.h
 * Conveyor belts of a case as triangle meshes (docs/belts.md): what carries of the belt, and its
 * skirts. Each straight run, the pulley, the belt behind it and the skirts are parts, since their
 * material moves each in its own way.
 */

#include "clod/case.h"
#include "clod/mesh.h"

/** Largest angle that a facet on a pulley spans [rad]. Contacts are with the cylinder for which
 *  it stands (clod_surface_make_round); pictures show the facet. */
#define CLOD_BELT_FACET (M_PI / 60.0)

/** A belt as a mesh, and how each part of it moves. */
typedef struct clod_setup_belt {
    clod_mesh *mesh;          ///< NULL: failed
    clod_case_surface *parts; ///< [parts of the mesh] materials borrowed from the case
} clod_setup_belt;

/**
 * Make the mesh of a belt.
 *
 * @param name  of the belt, for messages
 * @return      clod_setup_belt_fini
 * Errors  no mesh; CLOD_FAILED: memory.   Threads  safe.   Test  tests/setup/test_belt.c
 */
clod_setup_belt clod_setup_belt_make(const clod_case_belt *belt, const char *name,
                                     clod_status *status);

/** Free mesh and parts. */
void clod_setup_belt_fini(clod_setup_belt *self);
