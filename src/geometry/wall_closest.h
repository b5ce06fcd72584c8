#pragma once
/**
 * @file wall_closest.h
 * The closest point of a wall's shape, for CLOD_WIDTH grains at once: one text for the kernels
 * and for everybody else (simd.h).
 *
 * Facets of meshes are found otherwise (wall_facets.h). Other shapes come as four rows of four
 * numbers (wall_rows.h):
 *
 *   row 0   x y z [m] of the centre (shell: of the foot), kind: 0 box or bar, 2 plane,
 *           +1 or -1 shell whose grains are outside or inside
 *   row 1   first axis, half size along it [m]
 *   row 2   third axis (plane: normal, shell: its axis), half size along it [m]
 *   row 3   box: second axis, half size along it [m]
 *           shell: radius at its foot [m], slope along the radius and along the axis (unit),
 *           length of the slope [m]
 *
 * Disc, annulus, cylinder and cone are one shape: a straight line turned about the axis. In the
 * plane through the axis and the point, the closest point of the line is the closest of all.
 */

#include <float.h>

#include "state/shape_kinds.h"

/** Kinds in row 0; a shell has +1 or -1. */
#define CLOD_WALL_BOX 0.0
#define CLOD_WALL_PLANE 2.0
#define CLOD_WALL_MESH 3.0 ///< rows 0 to 3: pose of the wall (wall_facets.h)

/** Rows of a shape: where it is (wall_closest.h), and how its material moves. */
enum {
    CLOD_SHAPE_VELOCITY = 4, ///< m/s, of the wall where `lever` is 0; [3]: 1 with a belt
    CLOD_SHAPE_SPIN,         ///< rad/s, of the wall
    CLOD_SHAPE_ORIGIN,       ///< m, from where levers and the torque on the wall are taken
    CLOD_SHAPE_BELT,         ///< m/s, of the belt where `lever` is 0; [3]: along a direction
    CLOD_SHAPE_BELT_SPIN,    ///< rad/s, of the belt
    CLOD_SHAPE_DIRECTION,    ///< unit, in which the belt runs, projected onto the surface
    CLOD_SHAPE_ROWS
};

/** Kind in row 0 of each form; of a shell whose grains are inside its negative. */
static const double CLOD_WALL_KIND[CLOD_FORMS] = {[CLOD_FORM_PLANE] = CLOD_WALL_PLANE,
                                                  [CLOD_FORM_BOX] = CLOD_WALL_BOX,
                                                  [CLOD_FORM_SHELL] = 1.0,
                                                  [CLOD_FORM_MESH] = CLOD_WALL_MESH};

/** Form of a shape from its kind in row 0. Compared, not looked up in CLOD_WALL_KIND: the search
 *  asks it of every candidate. */
static inline clod_wall_form clod_wall_form_of(double kind)
{
    return kind == CLOD_WALL_PLANE  ? CLOD_FORM_PLANE
           : kind == CLOD_WALL_BOX  ? CLOD_FORM_BOX
           : kind == CLOD_WALL_MESH ? CLOD_FORM_MESH
                                    : CLOD_FORM_SHELL;
}

#include "simd/simd.h"

typedef struct clod_wall_closest {
    vreal distance; ///< m, from the surface to the point; below 0 in a box or behind a plane
    vreal3 normal;  ///< unit, from the surface to the point
} clod_wall_closest;

/** Where a point is beside the two kinds of surface with a closest point. */
typedef struct clod_wall_closest_away {
    vreal3 away;  ///< m, from the closest point to the point
    vreal square; ///< m2, of its length
    vreal3 on;    ///< normal if the point is on the surface (box: in it) ...
    vreal depth;  ///< m, and how deep
} clod_wall_closest_away;

static inline vreal clod_wall_closest_clamp(vreal x, vreal low, vreal high)
{
    return vreal_min(vreal_max(x, low), high);
}

/** Beside a shell; r from its foot, `height` along its axis. */
static inline clod_wall_closest_away clod_wall_closest_shell(vreal s[4][4], vreal3 r,
                                                             vreal height)
{
    const vreal3 axis = {s[2][0], s[2][1], s[2][2]};
    const vreal3 any = {s[1][0], s[1][1], s[1][2]};
    const vreal er = s[3][1];
    const vreal ez = s[3][2];
    const vreal zero = vreal_set(0.0);
    const vreal3 flat = vreal3_axpy(r, -height, axis);
    const vreal rho = vreal_sqrt(vreal3_dot(flat, flat));
    const vreal inverse = 1.0 / vreal_max(rho, vreal_set(DBL_MIN));
    const vreal3 radial =
        vreal3_select(vmask_less(zero, rho), vreal3_scale(flat, inverse), any);
    const vreal from = rho - s[3][0];
    const vreal along = from * er + height * ez;
    const vreal across = from * ez - height * er;
    const vreal beyond = along - clod_wall_closest_clamp(along, zero, s[3][3]);
    const vreal dr = across * ez + beyond * er;
    const vreal dz = beyond * ez - across * er;
    const vreal3 out = vreal3_axpy(vreal3_scale(radial, ez), -er, axis);
    return (clod_wall_closest_away){.away = vreal3_axpy(vreal3_scale(radial, dr), dz, axis),
                                    .square = dr * dr + dz * dz,
                                    .on = vreal3_scale(out, s[0][3]),
                                    .depth = zero};
}

/** Beside a solid box, or within it: out through the nearest face. */
static inline clod_wall_closest_away clod_wall_closest_box(vreal s[4][4], vreal3 r,
                                                           vreal height)
{
    const vreal3 axis[3] = {
        {s[1][0], s[1][1], s[1][2]}, {s[3][0], s[3][1], s[3][2]}, {s[2][0], s[2][1], s[2][2]}};
    const vreal half[3] = {s[1][3], s[3][3], s[2][3]};
    const vreal at[3] = {vreal3_dot(r, axis[0]), vreal3_dot(r, axis[1]), height};
    const vreal zero = vreal_set(0.0);
    clod_wall_closest_away beside = {{zero, zero, zero}, zero, {zero, zero, zero}, zero};
    for (int a = 0; a < 3; a++) {
        const vreal out = at[a] - clod_wall_closest_clamp(at[a], -half[a], half[a]);
        const vreal depth = half[a] - vreal_abs(at[a]);
        const vreal side =
            vreal_select(vmask_less(at[a], zero), vreal_set(-1.0), vreal_set(1.0));
        const vmask nearer = vmask_less(depth, beside.depth);
        const vreal3 face = vreal3_scale(axis[a], side);
        beside.away = vreal3_axpy(beside.away, out, axis[a]);
        beside.square = beside.square + out * out;
        beside.on = a == 0 ? face : vreal3_select(nearer, face, beside.on);
        beside.depth = a == 0 ? depth : vreal_select(nearer, depth, beside.depth);
    }
    return beside;
}

/**
 * The closest point of each lane's shape.
 *
 * @param form  of all lanes
 * @param s     rows of the shapes
 * @param p     the points [m]
 * Errors  none.   Threads  pure.   Test  tests/geometry/test_wall_gap.c, test_wall_cone.c
 */
__attribute__((always_inline)) static inline clod_wall_closest
clod_wall_closest_point(clod_wall_form form, vreal s[4][4], vreal3 p)
{
    const vreal3 axis = {s[2][0], s[2][1], s[2][2]};
    const vreal3 r = vreal3_sub(p, (vreal3){s[0][0], s[0][1], s[0][2]});
    const vreal height = vreal3_dot(r, axis);
    if (form == CLOD_FORM_PLANE) {
        return (clod_wall_closest){height, axis};
    }
    const bool box = form == CLOD_FORM_BOX;
    const clod_wall_closest_away beside =
        box ? clod_wall_closest_box(s, r, height) : clod_wall_closest_shell(s, r, height);
    const vreal least = vreal_set(DBL_MIN);
    clod_wall_closest at = {.distance = vreal_sqrt(beside.square)};
    at.normal = vreal3_scale(beside.away, 1.0 / vreal_max(at.distance, least));
    const vmask on = vmask_less(at.distance, least);
    if (vmask_any(on)) {
        at.normal = vreal3_select(on, beside.on, at.normal);
        at.distance = vreal_select(on, box ? -beside.depth : beside.depth, at.distance);
    }
    return at;
}
