#pragma once
/**
 * @file wall_mesh.h
 * The surfaces of the walls as triangles, where they are now, for looking at.
 */

#include "clod/status.h"
#include "state/state.h"

/** What wear tells of a triangle (docs/theory/wear.md). */
enum {
    CLOD_WALL_MESH_PRESSURE,      ///< mean since the sums began [Pa]
    CLOD_WALL_MESH_SHEAR_WORK,    ///< J/m2
    CLOD_WALL_MESH_IMPACT_ENERGY, ///< J/m2
    CLOD_WALL_MESH_IMPACTS,       ///< 1/m2
    CLOD_WALL_MESH_ARCHARD_DEPTH, ///< m
    CLOD_WALL_MESH_FINNIE_DEPTH,  ///< m
    CLOD_WALL_MESH_WEAR
};

/** Edges of a circle. */
#define CLOD_WALL_MESH_SEGMENTS 96

/** Bytes of the names of parts: an attribute of HDF5 has 64 KiB at most. */
#define CLOD_WALL_MESH_PARTS 60000

typedef struct clod_wall_mesh {
    size_t count;
    double (*corner)[3][3]; ///< owned [count]: corners of each triangle [m]
    double (*velocity)[3];  ///< owned [count]: of the wall's material at its middle [m/s]
    int32_t *wall;          ///< owned [count]: number of the wall
    int32_t *material;      ///< owned [count]
    int32_t *shape;         ///< owned [count]: clod_shape_kind of what it is cut from
    int32_t *part;          ///< owned [count]: number of the line of `parts`; -1: none
    char *parts; ///< owned: parts of meshes and belts, "WALL.PART", one a line; "": no names
    bool wears;  ///< some wall has sums of its places (state/wear.h)
    double (*wear)[CLOD_WALL_MESH_WEAR]; ///< owned [count] if so: densities, in that order
} clod_wall_mesh;

/**
 * Cut every shape of every wall into flat triangles.
 *
 * A plane is shown as a square as long as the domain's longest side, next to its middle; round
 * shapes as polygons of CLOD_WALL_MESH_SEGMENTS edges whose corners are on the surface.
 *
 * @param self  [out] owned (clod_wall_mesh_fini), also after a failure
 * Errors  CLOD_FAILED: no memory.   Threads  pure.   Test  tests/output/test_wall_mesh.c
 */
bool clod_wall_mesh_make(clod_wall_mesh *self, const clod_state *state, clod_status *status);

void clod_wall_mesh_fini(clod_wall_mesh *self);
