#pragma once
/**
 * @file surface.h
 * The facets of a mesh as grains meet them, in the frame of the wall. Contacts belong to patches,
 * which are pieces of the smooth surface; facets only tell where the closest point is
 * (docs/adr/0033).
 *
 * - A plane holds all facets that lie in it and hang together: one normal, however it is cut.
 * - A smooth piece holds facets that hang together over bends of less than the smooth angle.
 * - A patch is a part of a smooth piece whose normals differ from one of them by at most half
 *   the smooth angle.
 */

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/vec3.h"
#include "clod/mesh.h"

/** A plane of facets. */
typedef struct clod_surface_plane {
    clod_vec3 normal;  ///< unit
    clod_vec3 point;   ///< m
    uint32_t cylinder; ///< 1 + number of that which the facets stand for; 0: they are flat
} clod_surface_plane;

/** A cylinder on which the corners of facets lie, and for which they stand. */
typedef struct clod_surface_cylinder {
    clod_vec3 point; ///< m, on the axis
    clod_vec3 axis;  ///< unit
    double radius;   ///< m
} clod_surface_cylinder;

typedef struct clod_surface_patch {
    clod_vec3 axis[3];      ///< orthonormal; axis[2]: normal of its first facet
    double low[3], high[3]; ///< m, box along the axes of the frame
    double from[3], to[3];  ///< m, box along its own axes
    uint32_t part;          ///< of the mesh
    bool rims;              ///< some edge of it is open or sharp
} clod_surface_patch;

/** A node of the tree of boxes about facets. */
typedef struct clod_surface_node {
    double low[3], high[3];
    uint32_t first, count; ///< of `leaf` if count > 0; else children first and first + 1
} clod_surface_node;

/** Bit of a facet's rims: its connected piece has an open edge, so grains may come to both sides. */
#define CLOD_SURFACE_SHEET 8u

/** Bytes of a part's name, and of what tables call it: that, a number before it and one behind. */
#define CLOD_SURFACE_NAME (CLOD_MESH_NAME_MOST + 1)
#define CLOD_SURFACE_LABEL (CLOD_SURFACE_NAME + 32)

typedef struct clod_surface {
    atomic_int users;
    size_t vertex_count, facet_count, plane_count, patch_count, cylinder_count, part_count;
    double bulge;  ///< m, how far cylinders reach beyond their facets
    double weld;   ///< m, distance up to which the file's points are one
    double smooth; ///< rad
    double smooth_cosine;
    double (*vertex)[3];  ///< [vertex_count] m; owned, as the rest
    uint32_t (*facet)[3]; ///< [facet_count]
    uint32_t *plane;      ///< [facet_count]
    uint32_t *piece;      ///< [facet_count] smooth piece
    uint32_t *patch;      ///< [facet_count]
    uint32_t *part;       ///< [facet_count] of the mesh
    uint8_t *rims;        ///< [facet_count] bit e: edge e is open or sharp; CLOD_SURFACE_SHEET
    clod_surface_plane *planes;
    clod_surface_patch *patches;
    clod_surface_cylinder *cylinders;
    char (*part_name)[CLOD_SURFACE_NAME];   ///< [part_count] "": it has none
    char (*part_label)[CLOD_SURFACE_LABEL]; ///< [part_count] state/part_labels.h; "": no name
    clod_surface_node *node;
    uint32_t *leaf; ///< [facet_count] facets by leaf
} clod_surface;

/** The closest point of a facet. */
typedef struct clod_surface_closest {
    double distance;     ///< m, >= 0
    clod_vec3 point;     ///< m
    clod_vec3 direction; ///< unit, from it to where it was asked from
    uint8_t edges;       ///< bit e: it is on edge e of the facet
} clod_surface_closest;

/**
 * The surface of a mesh, with one user.
 *
 * @param then    turns and moves the mesh once more; NULL: it stays
 * @param smooth  rad, bends below it are smooth
 * @return        clod_surface_release, or NULL
 * Errors  CLOD_FAILED: memory.   Threads  pure.   Test  tests/mesh/test_surface_touch.c
 */
clod_surface *clod_surface_make(const clod_mesh *mesh, const clod_mesh_placing *then,
                                double smooth, clod_status *status);

/**
 * Let the facets of a part stand for a cylinder from now on: where a facet is, the surface is
 * round. For what is made of facets whose corners lie on it, and are narrow.
 *
 * @param part      of the mesh; planes that it shares with other parts stay flat
 * @param cylinder  in the frame of the surface
 * @return          false without memory
 * Test  tests/mesh/test_surface_round.c
 */
bool clod_surface_make_round(clod_surface *self, uint32_t part,
                             const clod_surface_cylinder *cylinder);

/** Memory that a surface takes [bytes]. */
size_t clod_surface_bytes(const clod_surface *self);

/** One more user; NULL is fine. */
clod_surface *clod_surface_share(clod_surface *self);

/** One user less: the last one frees it. NULL is fine. */
void clod_surface_release(clod_surface *self);

/** Closest point of a facet to p. Threads: pure. Test: tests/mesh/test_surface_touch.c */
clod_surface_closest clod_surface_closest_of(const clod_surface *self, uint32_t facet,
                                             clod_vec3 p);

/**
 * Closest point of a patch to p; infinitely far where it is farther than `most` [m].
 * Threads  pure.   Test  tests/mesh/test_surface_touch.c
 */
clod_surface_closest clod_surface_patch_closest(const clod_surface *self, uint32_t patch,
                                                clod_vec3 p, double most);

/** Whether any facet is within `reach` of p [m]. Threads: pure. */
bool clod_surface_is_near(const clod_surface *self, clod_vec3 p, double reach);

/** Whether a patch is within `reach` of p [m]. Threads: pure. */
bool clod_surface_patch_is_near(const clod_surface *self, uint32_t patch, clod_vec3 p,
                                double reach);

/**
 * Whether a rim of a patch is within `reach` of p [m]: an edge that is open or sharp.
 * Threads  pure.   Test  tests/mesh/test_surface_touch.c
 */
bool clod_surface_rim_is_near(const clod_surface *self, uint32_t patch, clod_vec3 p,
                              double reach);

/** Distance of a point from a box; 0 within [m]. */
static inline double clod_surface_box_distance(const double low[3], const double high[3],
                                               clod_vec3 p)
{
    const double at[3] = {p.x, p.y, p.z};
    double square = 0.0;
    for (int a = 0; a < 3; a++) {
        const double below = low[a] - at[a], above = at[a] - high[a];
        const double most = below > above ? below : above;
        const double out = most > 0.0 ? most : 0.0;
        square += out * out;
    }
    return sqrt(square);
}

/** Distance of a point from the box of a patch along its own axes: none of it is nearer [m]. */
static inline double clod_surface_patch_box(const clod_surface *self, uint32_t patch,
                                            clod_vec3 p)
{
    const clod_surface_patch *box = &self->patches[patch];
    const clod_vec3 at = {clod_vec3_dot(box->axis[0], p), clod_vec3_dot(box->axis[1], p),
                          clod_vec3_dot(box->axis[2], p)};
    return clod_surface_box_distance(box->from, box->to, at) - self->bulge;
}

/**
 * What to do with a facet that may be near: `reach` is the one asked for, or what it gave at the
 * facet before.
 * @return  the reach from now on [m]; below 0: it is enough
 */
typedef double (*clod_surface_take)(void *context, uint32_t facet, double reach);

/** Give every facet whose box, with others, is within `reach` of p to `take`. Threads: pure. */
void clod_surface_near(const clod_surface *self, clod_vec3 p, double reach,
                       clod_surface_take take, void *context);
