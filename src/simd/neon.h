#pragma once
/**
 * @file neon.h
 * Vector vocabulary on NEON (64-bit ARM): two doubles. See simd.h.
 */

#include <arm_neon.h>
#include <stdbool.h>
#include <stdint.h>

#define CLOD_WIDTH 2

typedef float64x2_t vreal;
typedef uint64x2_t vmask;

static inline vreal vreal_load(const double *from)
{
    return vld1q_f64(from);
}

static inline void vreal_store(double *to, vreal a)
{
    vst1q_f64(to, a);
}

static inline vreal vreal_set(double a)
{
    return vdupq_n_f64(a);
}

static inline vreal vreal_fma(vreal a, vreal b, vreal c)
{
    return vfmaq_f64(c, a, b);
}

static inline vreal vreal_sqrt(vreal a)
{
    return vsqrtq_f64(a);
}

static inline vreal vreal_abs(vreal a)
{
    return vabsq_f64(a);
}

static inline vreal vreal_round(vreal a)
{
    return vrndnq_f64(a);
}

static inline vreal vreal_select(vmask m, vreal a, vreal b)
{
    return vbslq_f64(m, a, b);
}

static inline vmask vmask_less(vreal a, vreal b)
{
    return vcltq_f64(a, b);
}

static inline bool vmask_any(vmask m)
{
    return vmaxvq_u32(vreinterpretq_u32_u64(m)) != 0;
}

/** Lane l of a mask in bit l. */
static inline unsigned vmask_bits(vmask m)
{
    return (unsigned)(vgetq_lane_u64(m, 0) & 1u) | (unsigned)(vgetq_lane_u64(m, 1) & 2u);
}

/** Not vminq_f64: that one gives NaN when either is NaN, and the lesser of two zeros. */
static inline vreal vreal_min(vreal a, vreal b)
{
    return vreal_select(vcltq_f64(a, b), a, b);
}

static inline vreal vreal_max(vreal a, vreal b)
{
    return vreal_select(vcgtq_f64(a, b), a, b);
}

static inline void vreal_load_rows(vreal out[4], const double (*rows)[4], const int32_t *index)
{
    for (int h = 0; h < 2; h++) {
        const vreal a = vld1q_f64(&rows[index[0]][2 * h]);
        const vreal b = vld1q_f64(&rows[index[1]][2 * h]);
        out[2 * h] = vzip1q_f64(a, b);
        out[2 * h + 1] = vzip2q_f64(a, b);
    }
}

static inline void vreal_store_rows(double (*rows)[8], const int32_t *index, const vreal in[8])
{
    for (int h = 0; h < 8; h += 2) {
        vst1q_f64(&rows[index[0]][h], vzip1q_f64(in[h], in[h + 1]));
        vst1q_f64(&rows[index[1]][h], vzip2q_f64(in[h], in[h + 1]));
    }
}

static inline void vreal_add_rows(double (*rows)[8], const int32_t *index, const vreal in[8],
                                  int lanes)
{
    for (int h = 0; h < 8 && lanes > 0; h += 2) {
        double *row = &rows[index[0]][h];
        vst1q_f64(row, vld1q_f64(row) + vzip1q_f64(in[h], in[h + 1]));
    }
    for (int h = 0; h < 8 && lanes > 1; h += 2) {
        double *row = &rows[index[1]][h];
        vst1q_f64(row, vld1q_f64(row) + vzip2q_f64(in[h], in[h + 1]));
    }
}
