#pragma once
/**
 * @file avx512.h
 * Vector vocabulary on AVX-512: eight doubles. See simd.h.
 */

#include <immintrin.h>
#include <stdbool.h>
#include <stdint.h>

#define CLOD_WIDTH 8

typedef __m512d vreal;
typedef __mmask8 vmask;

static inline vreal vreal_load(const double *from)
{
    return _mm512_loadu_pd(from);
}

static inline void vreal_store(double *to, vreal a)
{
    _mm512_storeu_pd(to, a);
}

static inline vreal vreal_set(double a)
{
    return _mm512_set1_pd(a);
}

static inline vreal vreal_fma(vreal a, vreal b, vreal c)
{
    return _mm512_fmadd_pd(a, b, c);
}

static inline vreal vreal_sqrt(vreal a)
{
    return _mm512_sqrt_pd(a);
}

static inline vreal vreal_abs(vreal a)
{
    return _mm512_abs_pd(a);
}

static inline vreal vreal_round(vreal a)
{
    return _mm512_roundscale_pd(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}

static inline vreal vreal_min(vreal a, vreal b)
{
    return _mm512_min_pd(a, b);
}

static inline vreal vreal_max(vreal a, vreal b)
{
    return _mm512_max_pd(a, b);
}

static inline vreal vreal_select(vmask m, vreal a, vreal b)
{
    return _mm512_mask_blend_pd(m, b, a);
}

static inline vmask vmask_less(vreal a, vreal b)
{
    return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ);
}

static inline bool vmask_any(vmask m)
{
    return m != 0;
}

/** Lane l of a mask in bit l. */
static inline unsigned vmask_bits(vmask m)
{
    return m;
}

/** Two rows of four doubles side by side. */
static inline vreal vreal_pair_rows(const double *low, const double *high)
{
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(low)), _mm256_load_pd(high),
                              1);
}

static inline void vreal_load_rows(vreal out[4], const double (*rows)[4], const int32_t *index)
{
    // rows paired so that after the unpacks every 128-bit part holds two lanes that belong
    // together, and parts 0 and 2 follow each other: shuffles of parts are cheap
    const vreal r02 = vreal_pair_rows(rows[index[0]], rows[index[2]]);
    const vreal r13 = vreal_pair_rows(rows[index[1]], rows[index[3]]);
    const vreal r46 = vreal_pair_rows(rows[index[4]], rows[index[6]]);
    const vreal r57 = vreal_pair_rows(rows[index[5]], rows[index[7]]);
    const vreal lo03 = _mm512_unpacklo_pd(r02, r13); // x0 x1 z0 z1 x2 x3 z2 z3
    const vreal hi03 = _mm512_unpackhi_pd(r02, r13); // y, w likewise
    const vreal lo47 = _mm512_unpacklo_pd(r46, r57);
    const vreal hi47 = _mm512_unpackhi_pd(r46, r57);
    out[0] = _mm512_shuffle_f64x2(lo03, lo47, 0x88);
    out[1] = _mm512_shuffle_f64x2(hi03, hi47, 0x88);
    out[2] = _mm512_shuffle_f64x2(lo03, lo47, 0xdd);
    out[3] = _mm512_shuffle_f64x2(hi03, hi47, 0xdd);
}

/** Lane l of all columns as row l. */
static inline void vreal_rows(__m512d row[8], const vreal in[8])
{
    const vreal a0 = _mm512_unpacklo_pd(in[0], in[1]); // columns 0 1 of lanes 0 2 4 6
    const vreal a1 = _mm512_unpackhi_pd(in[0], in[1]); // columns 0 1 of lanes 1 3 5 7
    const vreal b0 = _mm512_unpacklo_pd(in[2], in[3]);
    const vreal b1 = _mm512_unpackhi_pd(in[2], in[3]);
    const vreal c0 = _mm512_unpacklo_pd(in[4], in[5]);
    const vreal c1 = _mm512_unpackhi_pd(in[4], in[5]);
    const vreal d0 = _mm512_unpacklo_pd(in[6], in[7]);
    const vreal d1 = _mm512_unpackhi_pd(in[6], in[7]);
    // 128-bit parts: f64x2 shuffles bring the four column pairs of one lane together
    const vreal ab0_02 = _mm512_shuffle_f64x2(a0, b0, 0x44); // a(0) a(2) b(0) b(2)
    const vreal ab0_46 = _mm512_shuffle_f64x2(a0, b0, 0xee);
    const vreal cd0_02 = _mm512_shuffle_f64x2(c0, d0, 0x44);
    const vreal cd0_46 = _mm512_shuffle_f64x2(c0, d0, 0xee);
    const vreal ab1_13 = _mm512_shuffle_f64x2(a1, b1, 0x44);
    const vreal ab1_57 = _mm512_shuffle_f64x2(a1, b1, 0xee);
    const vreal cd1_13 = _mm512_shuffle_f64x2(c1, d1, 0x44);
    const vreal cd1_57 = _mm512_shuffle_f64x2(c1, d1, 0xee);
    row[0] = _mm512_shuffle_f64x2(ab0_02, cd0_02, 0x88);
    row[2] = _mm512_shuffle_f64x2(ab0_02, cd0_02, 0xdd);
    row[4] = _mm512_shuffle_f64x2(ab0_46, cd0_46, 0x88);
    row[6] = _mm512_shuffle_f64x2(ab0_46, cd0_46, 0xdd);
    row[1] = _mm512_shuffle_f64x2(ab1_13, cd1_13, 0x88);
    row[3] = _mm512_shuffle_f64x2(ab1_13, cd1_13, 0xdd);
    row[5] = _mm512_shuffle_f64x2(ab1_57, cd1_57, 0x88);
    row[7] = _mm512_shuffle_f64x2(ab1_57, cd1_57, 0xdd);
}

static inline void vreal_store_rows(double (*rows)[8], const int32_t *index, const vreal in[8])
{
    __m512d row[8];
    vreal_rows(row, in);
    for (int l = 0; l < 8; l++) {
        _mm512_store_pd(rows[index[l]], row[l]);
    }
}

static inline void vreal_add_rows(double (*rows)[8], const int32_t *index, const vreal in[8],
                                  int lanes)
{
    __m512d row[8];
    vreal_rows(row, in);
    if (lanes == 8) { // the rows stay in registers
        for (int l = 0; l < 8; l++) {
            _mm512_store_pd(rows[index[l]], _mm512_load_pd(rows[index[l]]) + row[l]);
        }
        return;
    }
    for (int l = 0; l < lanes; l++) {
        _mm512_store_pd(rows[index[l]], _mm512_load_pd(rows[index[l]]) + row[l]);
    }
}
