#pragma once
/**
 * @file vreal3.h
 * Vectors of space whose components are vectors of lanes. Included by simd.h.
 *
 * Here products and sums are fused, by name and alike in every set (docs/adr/0018); the laws
 * stay algebra.
 */

#include "simd/simd.h"

typedef struct vreal3 {
    vreal x, y, z;
} vreal3;

static inline vreal3 vreal3_add(vreal3 a, vreal3 b)
{
    return (vreal3){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline vreal3 vreal3_sub(vreal3 a, vreal3 b)
{
    return (vreal3){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline vreal3 vreal3_scale(vreal3 a, vreal s)
{
    return (vreal3){a.x * s, a.y * s, a.z * s};
}

/** a + s b */
static inline vreal3 vreal3_axpy(vreal3 a, vreal s, vreal3 b)
{
    return (vreal3){vreal_fma(s, b.x, a.x), vreal_fma(s, b.y, a.y), vreal_fma(s, b.z, a.z)};
}

static inline vreal vreal3_dot(vreal3 a, vreal3 b)
{
    return vreal_fma(a.z, b.z, vreal_fma(a.y, b.y, a.x * b.x));
}

static inline vreal3 vreal3_cross(vreal3 a, vreal3 b)
{
    return (vreal3){vreal_fma(a.y, b.z, -(a.z * b.y)), vreal_fma(a.z, b.x, -(a.x * b.z)),
                    vreal_fma(a.x, b.y, -(a.y * b.x))};
}

static inline vreal3 vreal3_select(vmask m, vreal3 a, vreal3 b)
{
    return (vreal3){vreal_select(m, a.x, b.x), vreal_select(m, a.y, b.y),
                    vreal_select(m, a.z, b.z)};
}

static inline vreal3 vreal3_load(double (*from)[8], int lane)
{
    return (vreal3){vreal_load(&from[0][lane]), vreal_load(&from[1][lane]),
                    vreal_load(&from[2][lane])};
}

static inline void vreal3_store(double (*to)[8], int lane, vreal3 a)
{
    vreal_store(&to[0][lane], a.x);
    vreal_store(&to[1][lane], a.y);
    vreal_store(&to[2][lane], a.z);
}
