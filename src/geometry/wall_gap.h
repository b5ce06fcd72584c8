#pragma once
/**
 * @file wall_gap.h
 * Distance of a point from each shape of a wall, by the exact closest point.
 *
 * - plane: endless and one-sided; the distance is negative behind it.
 * - box, bar: solid; inside, the distance is negative and the normal points out of the nearest
 *   face.
 * - disc, annulus, cylinder, cone: thin. They act from both sides, the normal points to the
 *   side on which the point is and the distance is never negative; beyond a rim the closest
 *   point is on the rim. So the distance is continuous everywhere, also for a grain that rolls
 *   over the rim of a shell and slides down its back. Cylinder and cone have no lids; a rim of
 *   radius 0 is the tip of a cone.
 *
 * Shapes are not repeated in periodic directions: give them the length of the domain.
 */

#include "geometry/wall_pose.h"

typedef struct clod_gap {
    double distance;  ///< m, from the closest point of the surface to the point
    clod_vec3 normal; ///< unit, from the wall to the point
} clod_gap;

static inline double clod_wall_gap_clamp(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

/**
 * Gap of a ring-like surface: (dr, dz) goes from the closest point to the point, along
 * `radial` and `axis`; `fallback` is the normal of a point on the surface itself.
 */
static inline clod_gap clod_wall_gap_ring(double dr, clod_vec3 radial, double dz,
                                          clod_vec3 axis, clod_vec3 fallback)
{
    const double distance = sqrt(dr * dr + dz * dz);
    if (distance == 0.0) {
        return (clod_gap){0.0, fallback};
    }
    const double scale = 1.0 / distance;
    const clod_vec3 along = clod_vec3_scale(radial, dr * scale);
    return (clod_gap){distance, clod_vec3_axpy(along, dz * scale, axis)};
}

/** Disc (inner radius 0) and annulus. */
static inline clod_gap clod_wall_gap_annulus(const clod_shape *s, clod_vec3 r)
{
    const double height = clod_vec3_dot(r, s->axis[2]);
    const clod_vec3 flat = clod_vec3_axpy(r, -height, s->axis[2]);
    const double rho = clod_vec3_length(flat);
    const double dr = rho - clod_wall_gap_clamp(rho, s->inner, s->outer);
    const clod_vec3 radial = rho > 0.0 ? clod_vec3_scale(flat, 1.0 / rho) : s->axis[0];
    return clod_wall_gap_ring(dr, radial, height, s->axis[2], s->axis[2]);
}

/** Shell of a cylinder that begins at its foot. */
static inline clod_gap clod_wall_gap_cylinder(const clod_shape *s, clod_vec3 r)
{
    const double height = clod_vec3_dot(r, s->axis[2]);
    const clod_vec3 flat = clod_vec3_axpy(r, -height, s->axis[2]);
    const double rho = clod_vec3_length(flat);
    const double dz = height - clod_wall_gap_clamp(height, 0.0, 2.0 * s->half[2]);
    const clod_vec3 radial = rho > 0.0 ? clod_vec3_scale(flat, 1.0 / rho) : s->axis[0];
    const double outwards = s->side == CLOD_SIDE_INSIDE ? -1.0 : 1.0;
    const clod_vec3 fallback = clod_vec3_scale(radial, outwards);
    return clod_wall_gap_ring(rho - s->outer, radial, dz, s->axis[2], fallback);
}

/**
 * Shell of a cone that begins at its foot with the radius `outer` and ends with `inner`. In the
 * plane through the axis and the point the shell is a straight line: the closest point of it is
 * the closest of all. With equal radii it has the bits of a cylinder.
 */
static inline clod_gap clod_wall_gap_cone(const clod_shape *s, clod_vec3 r)
{
    const double height = clod_vec3_dot(r, s->axis[2]);
    const clod_vec3 flat = clod_vec3_axpy(r, -height, s->axis[2]);
    const double rho = clod_vec3_length(flat);
    const double widening = s->inner - s->outer;
    const double rise = 2.0 * s->half[2];
    const double slant = sqrt(widening * widening + rise * rise);
    const double er = widening / slant; // along the line, from foot to top
    const double ez = rise / slant;
    const double along = (rho - s->outer) * er + height * ez;
    const double across = (rho - s->outer) * ez - height * er; // away from the axis
    const double beyond = along - clod_wall_gap_clamp(along, 0.0, slant);
    const clod_vec3 radial = rho > 0.0 ? clod_vec3_scale(flat, 1.0 / rho) : s->axis[0];
    const double outwards = s->side == CLOD_SIDE_INSIDE ? -1.0 : 1.0;
    const clod_vec3 fallback =
        clod_vec3_axpy(clod_vec3_scale(radial, outwards * ez), -outwards * er, s->axis[2]);
    return clod_wall_gap_ring(across * ez + beyond * er, radial, beyond * ez - across * er,
                              s->axis[2], fallback);
}

/** Out of a solid box through the nearest face; `l` is the point along the box's axes. */
static inline clod_gap clod_wall_gap_within(const clod_shape *s, const double l[3])
{
    int face = 0;
    double depth = s->half[0] - fabs(l[0]);
    for (int a = 1; a < 3; a++) {
        if (s->half[a] - fabs(l[a]) < depth) {
            depth = s->half[a] - fabs(l[a]);
            face = a;
        }
    }
    return (clod_gap){-depth, clod_vec3_scale(s->axis[face], l[face] < 0.0 ? -1.0 : 1.0)};
}

/** Solid box or bar. */
static inline clod_gap clod_wall_gap_box(const clod_shape *s, clod_vec3 r)
{
    const double l[3] = {clod_vec3_dot(r, s->axis[0]), clod_vec3_dot(r, s->axis[1]),
                         clod_vec3_dot(r, s->axis[2])};
    const double x = l[0] - clod_wall_gap_clamp(l[0], -s->half[0], s->half[0]);
    const double y = l[1] - clod_wall_gap_clamp(l[1], -s->half[1], s->half[1]);
    const double z = l[2] - clod_wall_gap_clamp(l[2], -s->half[2], s->half[2]);
    const double distance = sqrt(x * x + y * y + z * z);
    if (distance == 0.0) {
        return clod_wall_gap_within(s, l);
    }
    clod_vec3 normal = clod_vec3_scale(s->axis[0], x);
    normal = clod_vec3_axpy(normal, y, s->axis[1]);
    normal = clod_vec3_axpy(normal, z, s->axis[2]);
    return (clod_gap){distance, clod_vec3_scale(normal, 1.0 / distance)};
}

/**
 * Gap between a shape and a point.
 *
 * @param shape  a shape of a wall
 * @param p      the grain's centre in the wall's frame [m]
 * @return       distance and normal, both in the wall's frame
 * Errors  none.   Threads  pure.
 * Test    tests/geometry/test_wall_gap.c
 */
static inline clod_gap clod_wall_gap(const clod_shape *shape, clod_vec3 p)
{
    const clod_vec3 r = clod_vec3_sub(p, shape->center);
    switch (shape->kind) {
    case CLOD_SHAPE_PLANE:
        return (clod_gap){clod_vec3_dot(r, shape->axis[2]), shape->axis[2]};
    case CLOD_SHAPE_DISC:
    case CLOD_SHAPE_ANNULUS:
        return clod_wall_gap_annulus(shape, r);
    case CLOD_SHAPE_CYLINDER:
        return clod_wall_gap_cylinder(shape, r);
    case CLOD_SHAPE_CONE:
        return clod_wall_gap_cone(shape, r);
    default:
        return clod_wall_gap_box(shape, r);
    }
}

/**
 * The same with point and normal in space. A symmetric shape is where it is whatever the wall's
 * angle, so it is met without turning.
 */
static inline clod_gap clod_wall_gap_in_space(const clod_wall_pose *pose,
                                              const clod_shape *shape, clod_vec3 p)
{
    if (shape->symmetric) {
        return clod_wall_gap(shape, clod_vec3_sub(p, pose->shift));
    }
    clod_gap gap = clod_wall_gap(shape, clod_wall_to_frame(pose, p));
    gap.normal = clod_wall_to_space(pose, gap.normal);
    return gap;
}
