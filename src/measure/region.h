#pragma once
/**
 * @file region.h
 * Whether a point is in a region of the case.
 */

#include <stdbool.h>

#include "clod/case.h"

/** Whether a point is in a region, its border included. Threads: pure. */
static inline bool clod_region_has(const clod_case_region *self, const double p[3])
{
    if (self->kind == CLOD_REGION_BOX) {
        bool in = true;
        for (int a = 0; a < 3; a++) {
            in = in && p[a] >= self->min[a] && p[a] <= self->max[a];
        }
        return in;
    }
    const double x = p[0] - self->center[0], y = p[1] - self->center[1];
    const double r2 = x * x + y * y, rise = p[2] - self->center[2];
    return rise >= 0.0 && rise <= self->height &&
           r2 >= self->inner_radius * self->inner_radius &&
           r2 <= self->outer_radius * self->outer_radius;
}
