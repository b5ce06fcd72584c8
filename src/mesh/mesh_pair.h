#pragma once
/**
 * @file mesh_pair.h
 * Two facets beside each other: whether they lie over each other in one plane, or cut through each other.
 */

#include "mesh/mesh.h"

/** A facet while it is compared with others. */
typedef struct clod_mesh_pair_facet {
    uint32_t number;
    clod_vec3 corner[3];
    clod_vec3 normal; ///< as long as twice the area; from clod_mesh_pair_plane
    double square;    ///< of its length
    double low[3], high[3];
} clod_mesh_pair_facet;

/** The least of three finite numbers: as fmin, without its care for others. */
static inline double clod_mesh_pair_least(double a, double b, double c)
{
    const double least = a < b ? a : b;
    return least < c ? least : c;
}

/** The largest of three finite numbers. */
static inline double clod_mesh_pair_most(double a, double b, double c)
{
    const double most = a > b ? a : b;
    return most > c ? most : c;
}

/** Corners and box of a facet. */
static inline void clod_mesh_pair_corners(const clod_mesh *mesh, uint32_t number,
                                          clod_mesh_pair_facet *self)
{
    self->number = number;
    for (int c = 0; c < 3; c++) {
        self->corner[c] = clod_mesh_corner(mesh, number, c);
    }
    for (int k = 0; k < 3; k++) {
        const double *a = mesh->vertices[mesh->facets[number][0]];
        const double *b = mesh->vertices[mesh->facets[number][1]];
        const double *c = mesh->vertices[mesh->facets[number][2]];
        self->low[k] = clod_mesh_pair_least(a[k], b[k], c[k]);
        self->high[k] = clod_mesh_pair_most(a[k], b[k], c[k]);
    }
}

/** Normal of a facet that has its corners. */
static inline void clod_mesh_pair_plane(clod_mesh_pair_facet *self)
{
    self->normal = clod_vec3_cross(clod_vec3_sub(self->corner[1], self->corner[0]),
                                   clod_vec3_sub(self->corner[2], self->corner[0]));
    self->square = clod_vec3_dot(self->normal, self->normal);
}

/** What two facets are to each other. */
typedef enum clod_mesh_pair {
    CLOD_MESH_PAIR_APART,    ///< they touch at an edge or a corner, or not at all
    CLOD_MESH_PAIR_OVER,     ///< in one plane, with an area in common
    CLOD_MESH_PAIR_CROSSING, ///< they cut through each other
} clod_mesh_pair;

/**
 * What two facets are to each other.
 *
 * They lie over each other when the corners of one are within mesh->weld of the other's plane, and
 * they have an area in common that is wider than twice that in every direction of the plane.
 *
 * They cross when each has corners on both sides of the other's plane, farther from it than mesh->weld, and
 * both are cut by the other's plane along a common segment longer than mesh->weld. An edge
 * in the other's plane counts as a cut when the facet over that edge goes on beyond the plane.
 *
 * @param mesh  its neighbours are known
 * @param a, b  with their planes
 * @param at    [out] the middle of the common segment, where they cross
 * Errors  none.   Threads  pure.   Test  tests/mesh/test_mesh_overlaps.c, test_mesh_crossing.c
 */
clod_mesh_pair clod_mesh_pair_of(const clod_mesh *mesh, const clod_mesh_pair_facet *a,
                                 const clod_mesh_pair_facet *b, clod_vec3 *at);
