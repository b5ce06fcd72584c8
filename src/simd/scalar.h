#pragma once
/**
 * @file scalar.h
 * Vector vocabulary of width 1: plain C, the reference for every other set. See simd.h.
 */

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#define CLOD_WIDTH 1

typedef double vreal;
typedef bool vmask;

static inline vreal vreal_load(const double *from)
{
    return *from;
}

static inline void vreal_store(double *to, vreal a)
{
    *to = a;
}

static inline vreal vreal_set(double a)
{
    return a;
}

static inline vreal vreal_fma(vreal a, vreal b, vreal c)
{
    return fma(a, b, c);
}

static inline vreal vreal_sqrt(vreal a)
{
    return sqrt(a);
}

static inline vreal vreal_abs(vreal a)
{
    return fabs(a);
}

static inline vreal vreal_round(vreal a)
{
    return nearbyint(a);
}

static inline vreal vreal_min(vreal a, vreal b)
{
    return a < b ? a : b;
}

static inline vreal vreal_max(vreal a, vreal b)
{
    return a > b ? a : b;
}

static inline vreal vreal_select(vmask m, vreal a, vreal b)
{
    return m ? a : b;
}

static inline vmask vmask_less(vreal a, vreal b)
{
    return a < b;
}

static inline bool vmask_any(vmask m)
{
    return m;
}

/** Lane l of a mask in bit l. */
static inline unsigned vmask_bits(vmask m)
{
    return m ? 1u : 0u;
}

static inline void vreal_load_rows(vreal out[4], const double (*rows)[4], const int32_t *index)
{
    for (int c = 0; c < 4; c++) {
        out[c] = rows[*index][c];
    }
}

static inline void vreal_store_rows(double (*rows)[8], const int32_t *index, const vreal in[8])
{
    for (int c = 0; c < 8; c++) {
        rows[*index][c] = in[c];
    }
}

static inline void vreal_add_rows(double (*rows)[8], const int32_t *index, const vreal in[8],
                                  int lanes)
{
    for (int c = 0; c < 8 && lanes > 0; c++) {
        rows[*index][c] += in[c];
    }
}
