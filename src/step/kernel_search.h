#pragma once
/**
 * @file kernel_search.h
 * Which places are near one, and which pairs can meet. Included by kernel.c only.
 */

#include "step/kernel_contact.h"

/** As within_skin of step/cells.c, operation by operation. */
static inline unsigned kernel_within_some(const clod_kernel_search *self, const double p[4],
                                          size_t first)
{
    vreal s[3];
    for (int a = 0; a < 3; a++) {
        s[a] = vreal_set(p[a]) - vreal_load(&self->place[a][first]);
        if (self->period[a] > 0.0) {
            s[a] = kernel_image(s[a], self->period[a], self->inverse_period[a]);
        }
    }
    const vreal reach =
        vreal_set(p[3]) + vreal_load(&self->place[3][first]) + vreal_set(self->skin);
    const vreal square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
    return vmask_bits(vmask_less(square, reach * reach));
}

static size_t kernel_within(const clod_kernel_search *self, const double p[4], int32_t row,
                            size_t first, size_t count, int32_t *found)
{
    uint64_t bits = 0;
    for (size_t k = 0; k < count; k += CLOD_WIDTH) {
        bits |= (uint64_t)kernel_within_some(self, p, first + k) << k;
    }
    bits = count < 64 ? bits & ~(~(uint64_t)0 << count) : bits;
    size_t rows = 0;
    for (; bits != 0; bits &= bits - 1) { // every other row is an earlier one: no branch
        found[rows] = self->row[first + (size_t)__builtin_ctzll(bits)];
        rows += found[rows] > row;
    }
    return rows;
}

static inline vreal3 kernel_courses_apart(const clod_kernel_courses *self, const vreal a[4],
                                          const vreal b[4])
{
    vreal s[3];
    for (int c = 0; c < 3; c++) {
        s[c] = a[c] - b[c];
        if (self->period[c] > 0.0) {
            s[c] = kernel_image(s[c], self->period[c], self->inverse_period[c]);
        }
    }
    return (vreal3){s[0], s[1], s[2]};
}

/** Rows of courses, as vreal_load_rows loads rows of doubles. */
static inline void kernel_load_courses(vreal out[4], const float (*rows)[4],
                                       const int32_t *index)
{
    _Alignas(4 * sizeof(double)) double wide[CLOD_WIDTH][4];
    int32_t lane[CLOD_WIDTH];
    for (int l = 0; l < CLOD_WIDTH; l++) {
        lane[l] = l;
        for (int c = 0; c < 4; c++) {
            wide[l][c] = (double)rows[index[l]][c];
        }
    }
    vreal_load_rows(out, (const double(*)[4])wide, lane);
}

/** Pairs that touch are nearer than radii and skins where their courses bring them nearest. */
static inline vmask kernel_courses_meet(const clod_kernel_courses *self, const int32_t *i,
                                        const int32_t *j)
{
    vreal pi[4], pj[4], ci[4], cj[4];
    vreal_load_rows(pi, self->position, i);
    vreal_load_rows(pj, self->position, j);
    kernel_load_courses(ci, self->course, i);
    kernel_load_courses(cj, self->course, j);
    const vreal reach = pi[3] + pj[3] + ci[3] + cj[3], zero = vreal_set(0.0);
    vreal3 apart = kernel_courses_apart(self, pi, pj);
    if (self->horizon > 0.0) {
        const vreal3 v = {ci[0] - cj[0], ci[1] - cj[1], ci[2] - cj[2]};
        const vreal closing = zero - vreal3_dot(apart, v);
        const vreal time =
            vreal_min(closing / vreal3_dot(v, v), vreal_set(self->horizon)); // 0/0: not closing
        apart = vreal3_axpy(apart, vreal_select(vmask_less(zero, closing), time, zero), v);
    }
    return vmask_less(vreal3_dot(apart, apart), reach * reach);
}

static uint64_t kernel_can_touch(const clod_kernel_courses *self, const int32_t *i,
                                 const int32_t *j, size_t count)
{
    uint64_t bits = 0;
    for (size_t k = 0; k < count; k += CLOD_WIDTH) {
        bits |= (uint64_t)vmask_bits(kernel_courses_meet(self, i + k, j + k)) << k;
    }
    return count < 64 ? bits & ~(~(uint64_t)0 << count) : bits;
}
