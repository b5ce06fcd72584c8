#pragma once
/**
 * @file vec3.h
 * Vectors and rotations of space, for everything outside the kernels.
 */

#include <math.h>
#include <stdbool.h>

typedef struct clod_vec3 {
    double x, y, z;
} clod_vec3;

static inline clod_vec3 clod_vec3_of(const double v[3])
{
    return (clod_vec3){v[0], v[1], v[2]};
}

static inline void clod_vec3_put(double to[3], clod_vec3 from)
{
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

static inline clod_vec3 clod_vec3_add(clod_vec3 a, clod_vec3 b)
{
    return (clod_vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline clod_vec3 clod_vec3_sub(clod_vec3 a, clod_vec3 b)
{
    return (clod_vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline clod_vec3 clod_vec3_scale(clod_vec3 a, double s)
{
    return (clod_vec3){a.x * s, a.y * s, a.z * s};
}

/** a + s b */
static inline clod_vec3 clod_vec3_axpy(clod_vec3 a, double s, clod_vec3 b)
{
    return (clod_vec3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline double clod_vec3_dot(clod_vec3 a, clod_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline clod_vec3 clod_vec3_cross(clod_vec3 a, clod_vec3 b)
{
    return (clod_vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double clod_vec3_length(clod_vec3 a)
{
    return sqrt(clod_vec3_dot(a, a));
}

/** Unit vector along a; a must not be zero. */
static inline clod_vec3 clod_vec3_unit(clod_vec3 a)
{
    return clod_vec3_scale(a, 1.0 / clod_vec3_length(a));
}

/** Two directions that make a right-handed frame with axis[2], of unit length. */
static inline void clod_vec3_complete(clod_vec3 axis[3])
{
    const clod_vec3 z = axis[2];
    const clod_vec3 aside =
        fabs(z.x) < 0.5 ? (clod_vec3){1.0, 0.0, 0.0} : (clod_vec3){0.0, 1.0, 0.0};
    axis[0] = clod_vec3_unit(clod_vec3_axpy(aside, -clod_vec3_dot(aside, z), z));
    axis[1] = clod_vec3_cross(z, axis[0]);
}

/** Rotate a about the unit vector `axis` by `angle` [rad] (Rodrigues). */
static inline clod_vec3 clod_vec3_rotate(clod_vec3 a, clod_vec3 axis, double angle)
{
    const double c = cos(angle);
    const double s = sin(angle);
    const clod_vec3 turned = clod_vec3_axpy(clod_vec3_scale(a, c), s, clod_vec3_cross(axis, a));
    return clod_vec3_axpy(turned, clod_vec3_dot(axis, a) * (1.0 - c), axis);
}

/** Whether two vectors are the same numbers. */
static inline bool clod_vec3_same(clod_vec3 a, clod_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/** Axis of space that is nearest to a direction; of two alike the first. */
static inline int clod_vec3_nearest_axis(const double n[3])
{
    const int axis = fabs(n[1]) > fabs(n[0]) ? 1 : 0;
    return fabs(n[2]) > fabs(n[axis]) ? 2 : axis;
}
