#pragma once
/**
 * @file surface_facet.h
 * A facet with all that its closest point needs, side by side: what lists of facets near a grain
 * are made of, so that a step reads nothing else of the mesh.
 */

#include <math.h>

#include "mesh/surface.h"

/** Rounding of an edge function that counts as inside, as a fraction of the square of the edge. */
#define CLOD_SURFACE_INSIDE 1e-12

typedef struct clod_surface_facet {
    const clod_surface *surface; ///< borrowed
    clod_vec3 normal, point;     ///< of its plane
    clod_vec3 corner[3];         ///< m
    clod_vec3 inward[3];         ///< m, across edge e in the plane, as long as the edge
    double square[3];            ///< m2, of the length of edge e
    uint32_t number;             ///< in the surface
    uint32_t plane, patch;
    uint32_t cylinder; ///< as its plane has it
    uint8_t rims;      ///< bit e: edge e is open or sharp
} clod_surface_facet;

/** A facet by its number. Threads: pure. */
clod_surface_facet clod_surface_facet_of(const clod_surface *self, uint32_t number);

/** Closest point to a place that is not over the triangle, or on a cylinder. Threads: pure. */
clod_surface_closest clod_surface_facet_beside(const clod_surface *self,
                                               const clod_surface_facet *facet, clod_vec3 p);

/** Whether a rim of a facet is within `reach` of p [m]. Threads: pure. */
bool clod_surface_facet_rim_is_near(const clod_surface_facet *self, clod_vec3 p, double reach);

/** Whether the box about a facet, with the cylinders' bulge, is farther from p than `reach` [m].
 */
bool clod_surface_facet_box_is_far(const clod_surface *self, uint32_t number, clod_vec3 p,
                                   double reach);

/** clod_surface_facet_is_beyond for a facet that stands for a cylinder. */
bool clod_surface_facet_is_beyond_round(const clod_surface *self,
                                        const clod_surface_facet *facet, clod_vec3 p,
                                        double reach);

/** Whether a point of the facet's plane is within its edges. */
static inline bool clod_surface_facet_holds(const clod_surface_facet *self, clod_vec3 at)
{
    bool inside = true;
    for (int e = 0; e < 3; e++) {
        const double in = clod_vec3_dot(clod_vec3_sub(at, self->corner[e]), self->inward[e]);
        inside &= in >= -CLOD_SURFACE_INSIDE * self->square[e];
    }
    return inside;
}

/** Height over the facet's plane; negative behind it [m]. */
static inline double clod_surface_facet_height(const clod_surface_facet *self, clod_vec3 p)
{
    return clod_vec3_dot(clod_vec3_sub(p, self->point), self->normal);
}

/**
 * Whether a facet is farther from p than `reach`, as far as its plane and the lines through its
 * edges tell, or a box about its piece of a cylinder; false where that is not sure.
 */
static inline bool clod_surface_facet_is_beyond(const clod_surface *self,
                                                const clod_surface_facet *facet, clod_vec3 p,
                                                double reach)
{
    if (facet->cylinder != 0) {
        return clod_surface_facet_is_beyond_round(self, facet, p, reach);
    }
    const double height = clod_surface_facet_height(facet, p);
    const clod_vec3 foot = clod_vec3_axpy(p, -height, facet->normal);
    const double most = reach + 2.0 * self->weld; // corners may be off their plane
    const double left = most * most - height * height;
    bool beyond = left < 0.0;
    for (int e = 0; e < 3; e++) {
        const double in =
            clod_vec3_dot(clod_vec3_sub(foot, facet->corner[e]), facet->inward[e]);
        beyond |= in < 0.0 && in * in > left * facet->square[e];
    }
    return beyond;
}

/** Direction of the facet's plane towards the side of a height. */
static inline clod_vec3 clod_surface_facet_side(const clod_surface_facet *self, double height)
{
    return height < 0.0 ? clod_vec3_scale(self->normal, -1.0) : self->normal;
}

/** Closest point to p, written part by part: a copy of the whole waits for what was just written.
 *  Threads: pure. */
static inline void clod_surface_facet_find(const clod_surface_facet *self, clod_vec3 p,
                                           clod_surface_closest *closest)
{
    const double height = clod_surface_facet_height(self, p);
    const clod_vec3 foot = clod_vec3_axpy(p, -height, self->normal);
    if (self->cylinder != 0 || !clod_surface_facet_holds(self, foot)) {
        *closest = clod_surface_facet_beside(self->surface, self, p);
        return;
    }
    closest->distance = fabs(height);
    closest->point = foot;
    closest->direction = clod_surface_facet_side(self, height);
    closest->edges = 0;
}

/** Closest point to p. Threads: pure. Test: tests/mesh/test_surface_touch.c */
static inline clod_surface_closest clod_surface_facet_closest(const clod_surface_facet *self,
                                                              clod_vec3 p)
{
    clod_surface_closest closest;
    clod_surface_facet_find(self, p, &closest);
    return closest;
}
