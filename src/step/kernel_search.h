#pragma once
/**
 * @file kernel_search.h
 * Which places are near one. Included by kernel.c only.
 */

#include "step/kernel_contact.h"

/** As within_skin of step/cells.c, operation by operation. */
static uint64_t kernel_within(const clod_kernel_search *self, const double p[4], size_t first,
                              size_t count)
{
    uint64_t bits = 0;
    for (size_t k = 0; k < count; k += CLOD_WIDTH) {
        vreal s[3];
        for (int a = 0; a < 3; a++) {
            s[a] = vreal_set(p[a]) - vreal_load(&self->place[a][first + k]);
            if (self->period[a] > 0.0) {
                s[a] = kernel_image(s[a], self->period[a], self->inverse_period[a]);
            }
        }
        const vreal reach =
            vreal_set(p[3]) + vreal_load(&self->place[3][first + k]) + vreal_set(self->skin);
        const vreal square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
        bits |= (uint64_t)vmask_bits(vmask_less(square, reach * reach)) << k;
    }
    return count < 64 ? bits & ~(~(uint64_t)0 << count) : bits;
}
