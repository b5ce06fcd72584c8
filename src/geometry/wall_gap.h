#pragma once
/**
 * @file wall_gap.h
 * Distance of a point from each shape of a wall, by the exact closest point; one point at a
 * time, for everybody but the kernels.
 *
 * - plane: endless and one-sided; the distance is negative behind it.
 * - box, bar: solid; inside, the distance is negative and the normal points out of the nearest
 *   face.
 * - disc, annulus, cylinder, cone: thin. They act from both sides, the normal points to the
 *   side on which the point is and the distance is never negative; beyond a rim the closest
 *   point is on the rim. So the distance is continuous everywhere, also for a grain that rolls
 *   over the rim of a shell and slides down its back. Cylinder and cone have no lids; a rim of
 *   radius 0 is the tip of a cone.
 * - mesh: thin, as these; a shape is a patch of it.
 *
 * Shapes are not repeated in periodic directions: give them the length of the domain.
 */

#include "base/vec3.h"
#include "geometry/wall_closest.h"
#include "state/walls.h"

typedef struct clod_gap {
    double distance;  ///< m, from the closest point of the surface to the point
    clod_vec3 normal; ///< unit, from the wall to the point
} clod_gap;

static inline void clod_wall_shape_row(double row[4], clod_vec3 v, double last)
{
    row[0] = v.x;
    row[1] = v.y;
    row[2] = v.z;
    row[3] = last;
}

/** The line that makes a shell when it is turned about its axis, as row 3 of wall_closest.h. */
static inline void clod_wall_shape_line(const clod_shape *s, double row[4])
{
    const double widening = clod_shape_end_radius(s) - s->outer;
    const double rise = clod_shape_kinds_row(s->kind)->flat ? 0.0 : 2.0 * s->half[2];
    const double slant = sqrt(widening * widening + rise * rise);
    const bool ring = slant == 0.0; // a line of no length: any slope will do
    const double line[4] = {s->outer, ring ? 0.0 : widening / slant, ring ? 1.0 : rise / slant,
                            slant};
    for (int c = 0; c < 4; c++) {
        row[c] = line[c];
    }
}

/** A shape as the rows of wall_closest.h; disc and annulus go from the outer rim inwards. */
static inline void clod_wall_shape_rows(const clod_shape *s, double (*row)[4])
{
    const clod_shape_kind_row *kind = clod_shape_kinds_row(s->kind);
    const double side = kind->shell && s->side == CLOD_SIDE_INSIDE ? -1.0 : 1.0;
    clod_wall_shape_row(row[0], s->center, side * CLOD_WALL_KIND[kind->form]);
    clod_wall_shape_row(row[1], s->axis[0], s->half[0]);
    clod_wall_shape_row(row[2], s->axis[2], s->half[2]);
    clod_wall_shape_row(row[3], s->axis[1], s->half[1]);
    if (kind->form == CLOD_FORM_SHELL) {
        clod_wall_shape_line(s, row[3]);
    }
}

/**
 * Gap between a shape and a point.
 *
 * @param row  [4][4] rows of the shape
 * @param p    the grain's centre, in the frame of the rows [m]
 * Errors  none.   Threads  pure.   Test  tests/geometry/test_wall_rows.c
 */
static inline clod_gap clod_wall_gap_rows(const double (*row)[4], clod_vec3 p)
{
    static const int32_t FIRST[CLOD_WIDTH] = {0};
    vreal s[4][4];
    for (int k = 0; k < 4; k++) {
        vreal_load_rows(s[k], row + k, FIRST);
    }
    const vreal3 point = {vreal_set(p.x), vreal_set(p.y), vreal_set(p.z)};
    const clod_wall_closest at =
        clod_wall_closest_point(clod_wall_form_of(row[0][3]), s, point);
    return (clod_gap){at.distance, {at.normal.x, at.normal.y, at.normal.z}};
}

/** Gap between a patch of a mesh and a point, both in the wall's frame. */
static inline clod_gap clod_wall_gap_patch(const clod_surface *surface, int32_t patch,
                                           clod_vec3 p)
{
    const clod_surface_closest at =
        clod_surface_patch_closest(surface, (uint32_t)patch, p, INFINITY);
    return (clod_gap){at.distance, at.direction};
}

/**
 * The same of a shape as it was given.
 *
 * @param shape  a shape of a wall
 * @param p      the grain's centre in the wall's frame [m]
 * @return       distance and normal, both in the wall's frame
 * Errors  none.   Threads  pure.   Test  tests/geometry/test_wall_gap.c
 */
static inline clod_gap clod_wall_gap(const clod_shape *shape, clod_vec3 p)
{
    if (clod_shape_kinds_row(shape->kind)->faceted) {
        return clod_wall_gap_patch(shape->surface, shape->patch, p);
    }
    double row[4][4];
    clod_wall_shape_rows(shape, row);
    return clod_wall_gap_rows((const double(*)[4])row, p);
}
