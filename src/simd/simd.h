#pragma once
/**
 * @file simd.h
 * The vector vocabulary of the kernels: `vreal` holds CLOD_WIDTH doubles, `vmask` as many
 * truths.
 *
 * + - * / are written with the ordinary operators, on vectors and between a vector and a
 * double. Every operation rounds each lane as IEEE 754 says, so all instruction sets give the
 * same bits; the scalar set (width 1) is the reference that a reader and the tests use.
 *
 *   vreal_load, vreal_store         CLOD_WIDTH doubles in a row
 *   vreal_set(a)                    a in every lane
 *   vreal_fma(a, b, c)              a b + c, rounded once
 *   vreal_sqrt, vreal_abs, vreal_round (to nearest, ties to even)
 *   vreal_min(a, b)                 a < b ? a : b           (b when one is NaN)
 *   vreal_max(a, b)                 a > b ? a : b           (b when one is NaN)
 *   vreal_select(m, a, b)           m ? a : b
 *   vmask_less(a, b)                a < b                   (false for NaN)
 *   vmask_any(m)                    true when a lane is true
 *   vreal_load_rows                 lane l of out[c] = rows[index[l]][c], c < 4
 *   vreal_store_rows                rows[index[l]][c] = lane l of in[c], c < 8
 *   vreal_add_rows                  rows[index[l]][c] += lane l of in[c], c < 8, for the first
 *                                   lanes, one after the other: a row may come more than once
 *
 * Test  tests/simd/test_simd.c
 */

#if defined(CLOD_SIMD_AVX512)
#include "simd/avx512.h"
#elif defined(CLOD_SIMD_AVX2)
#include "simd/avx2.h"
#elif defined(CLOD_SIMD_NEON)
#include "simd/neon.h"
#else
#include "simd/scalar.h"
#endif

#include "simd/vreal3.h"
#include "simd/vreal_invert.h"
