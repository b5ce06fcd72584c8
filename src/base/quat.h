#pragma once
/**
 * @file quat.h
 * Rotations of space as unit quaternions w + x i + y j + z k (Hamilton's product).
 */

#include <stdbool.h>

#include "base/vec3.h"

typedef struct clod_quat {
    double w, x, y, z;
} clod_quat;

/** No rotation. */
#define CLOD_QUAT_NONE ((clod_quat){1.0, 0.0, 0.0, 0.0})

/** Whether it turns by exactly nothing. */
static inline bool clod_quat_is_none(clod_quat q)
{
    return q.x == 0.0 && q.y == 0.0 && q.z == 0.0;
}

/** First b, then a. */
static inline clod_quat clod_quat_product(clod_quat a, clod_quat b)
{
    return (clod_quat){a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
                       a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                       a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                       a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/** The unit quaternion along q; q must not be zero. */
static inline clod_quat clod_quat_unit(clod_quat q)
{
    const double s = 1.0 / sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    return (clod_quat){q.w * s, q.x * s, q.y * s, q.z * s};
}

/** Rotation about a unit vector by an angle [rad]; by exactly nothing when the angle is 0. */
static inline clod_quat clod_quat_about(clod_vec3 axis, double angle)
{
    const double s = sin(0.5 * angle);
    return (clod_quat){cos(0.5 * angle), s * axis.x, s * axis.y, s * axis.z};
}

/** Rotation matrix of a unit quaternion. */
static inline void clod_quat_matrix(clod_quat q, double r[3][3])
{
    const double rows[3][3] = {{1.0 - 2.0 * (q.y * q.y + q.z * q.z),
                                2.0 * (q.x * q.y - q.w * q.z), 2.0 * (q.x * q.z + q.w * q.y)},
                               {2.0 * (q.x * q.y + q.w * q.z),
                                1.0 - 2.0 * (q.x * q.x + q.z * q.z),
                                2.0 * (q.y * q.z - q.w * q.x)},
                               {2.0 * (q.x * q.z - q.w * q.y), 2.0 * (q.y * q.z + q.w * q.x),
                                1.0 - 2.0 * (q.x * q.x + q.y * q.y)}};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            r[i][j] = rows[i][j];
        }
    }
}

/** A vector, turned. */
static inline clod_vec3 clod_quat_rotate(clod_quat q, clod_vec3 a)
{
    const clod_vec3 u = {q.x, q.y, q.z};
    const clod_vec3 twice = clod_vec3_scale(clod_vec3_cross(u, a), 2.0);
    return clod_vec3_add(clod_vec3_axpy(a, q.w, twice), clod_vec3_cross(u, twice));
}
