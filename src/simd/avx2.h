#pragma once
/**
 * @file avx2.h
 * Vector vocabulary on AVX2: four doubles. See simd.h.
 */

#include <immintrin.h>
#include <stdbool.h>
#include <stdint.h>

#define CLOD_WIDTH 4

typedef __m256d vreal;
typedef __m256d vmask;

static inline vreal vreal_load(const double *from)
{
    return _mm256_loadu_pd(from);
}

static inline void vreal_store(double *to, vreal a)
{
    _mm256_storeu_pd(to, a);
}

static inline vreal vreal_set(double a)
{
    return _mm256_set1_pd(a);
}

static inline vreal vreal_fma(vreal a, vreal b, vreal c)
{
    return _mm256_fmadd_pd(a, b, c);
}

static inline vreal vreal_sqrt(vreal a)
{
    return _mm256_sqrt_pd(a);
}

static inline vreal vreal_abs(vreal a)
{
    return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
}

static inline vreal vreal_round(vreal a)
{
    return _mm256_round_pd(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}

static inline vreal vreal_min(vreal a, vreal b)
{
    return _mm256_min_pd(a, b);
}

static inline vreal vreal_max(vreal a, vreal b)
{
    return _mm256_max_pd(a, b);
}

static inline vreal vreal_select(vmask m, vreal a, vreal b)
{
    return _mm256_blendv_pd(b, a, m);
}

static inline vmask vmask_less(vreal a, vreal b)
{
    return _mm256_cmp_pd(a, b, _CMP_LT_OQ);
}

static inline bool vmask_any(vmask m)
{
    return _mm256_movemask_pd(m) != 0;
}

/** Lane l of a mask in bit l. */
static inline unsigned vmask_bits(vmask m)
{
    return (unsigned)_mm256_movemask_pd(m);
}

/** Transpose a 4 x 4 matrix held in four vectors. */
static inline void vreal_transpose4(vreal out[4], vreal r0, vreal r1, vreal r2, vreal r3)
{
    const vreal lo01 = _mm256_unpacklo_pd(r0, r1);
    const vreal hi01 = _mm256_unpackhi_pd(r0, r1);
    const vreal lo23 = _mm256_unpacklo_pd(r2, r3);
    const vreal hi23 = _mm256_unpackhi_pd(r2, r3);
    out[0] = _mm256_permute2f128_pd(lo01, lo23, 0x20);
    out[1] = _mm256_permute2f128_pd(hi01, hi23, 0x20);
    out[2] = _mm256_permute2f128_pd(lo01, lo23, 0x31);
    out[3] = _mm256_permute2f128_pd(hi01, hi23, 0x31);
}

static inline void vreal_load_rows(vreal out[4], const double (*rows)[4], const int32_t *index)
{
    vreal_transpose4(out, _mm256_load_pd(rows[index[0]]), _mm256_load_pd(rows[index[1]]),
                     _mm256_load_pd(rows[index[2]]), _mm256_load_pd(rows[index[3]]));
}

static inline void vreal_store_rows(double (*rows)[8], const int32_t *index, const vreal in[8])
{
    vreal half[4];
    for (int h = 0; h < 2; h++) {
        vreal_transpose4(half, in[4 * h], in[4 * h + 1], in[4 * h + 2], in[4 * h + 3]);
        for (int l = 0; l < 4; l++) {
            _mm256_store_pd(&rows[index[l]][4 * h], half[l]);
        }
    }
}

static inline void vreal_add_rows(double (*rows)[8], const int32_t *index, const vreal in[8],
                                  int lanes)
{
    vreal low[4], high[4];
    vreal_transpose4(low, in[0], in[1], in[2], in[3]);
    vreal_transpose4(high, in[4], in[5], in[6], in[7]);
    for (int l = 0; l < lanes; l++) {
        double *row = rows[index[l]];
        _mm256_store_pd(row, _mm256_load_pd(row) + low[l]);
        _mm256_store_pd(row + 4, _mm256_load_pd(row + 4) + high[l]);
    }
}
