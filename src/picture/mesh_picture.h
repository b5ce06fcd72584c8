#pragma once
/**
 * @file mesh_picture.h
 * The faults of a mesh, as a picture of it shows them: one for each facet.
 */

#include "clod/mesh.h"

/** What a picture of a mesh tells of a facet; of several the first. */
typedef enum clod_mesh_fault {
    CLOD_MESH_FAULT_NONMANIFOLD,
    CLOD_MESH_FAULT_TWISTED,
    CLOD_MESH_FAULT_DUPLICATE, ///< facets in its place were dropped
    CLOD_MESH_FAULT_OVERLAP,   ///< over or below another one in its plane
    CLOD_MESH_FAULT_CROSSING,  ///< cut through by another one
    CLOD_MESH_FAULT_TURNED,
    CLOD_MESH_FAULT_NEEDLE,
    CLOD_MESH_FAULT_SLIVER,
    CLOD_MESH_FAULT_T,
    CLOD_MESH_FAULT_OPEN,
    CLOD_MESH_FAULT_NONE,
    CLOD_MESH_FAULTS,
} clod_mesh_fault;

/** Fault of a facet. Threads: pure.   Test  tests/picture/test_mesh_picture.c */
clod_mesh_fault clod_mesh_picture_fault(const clod_mesh_view *view, size_t facet);
