#pragma once
/**
 * @file vreal_invert.h
 * Reciprocals of several numbers by one division. A vector division costs as much as a dozen
 * products; the reciprocal of a product gives those of its factors (docs/adr/0010). Each is
 * right within three roundings, the first two of three numbers within five, where the product
 * neither overflows nor underflows: the caller says why it does not. Included by simd.h.
 *
 * Test  tests/simd/test_simd.c
 */

#include "simd/simd.h"

/** 1/a and 1/b in their places. */
static inline void vreal_invert2(vreal *a, vreal *b)
{
    const vreal inverse = 1.0 / (*a * *b);
    const vreal inverse_a = inverse * *b;
    *b = inverse * *a;
    *a = inverse_a;
}

/** 1/a, 1/b and 1/c in their places. */
static inline void vreal_invert3(vreal *a, vreal *b, vreal *c)
{
    vreal ab = *a * *b;
    const vreal factor = *a;
    vreal_invert2(&ab, c);
    *a = ab * *b;
    *b = ab * factor;
}
