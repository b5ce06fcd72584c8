#include "config/region.h"

#include <math.h>

void clod_region_bounds(const clod_case_region *self, double low[3], double high[3])
{
    const bool box = self->kind == CLOD_REGION_BOX;
    for (int a = 0; a < 3; a++) {
        const double down = a < 2 ? self->outer_radius : 0.0;
        const double up = a < 2 ? self->outer_radius : self->height;
        low[a] = box ? self->min[a] : self->center[a] - down;
        high[a] = box ? self->max[a] : self->center[a] + up;
    }
}

/** Whether one of two annuli is in the hole of the other, or beside it. */
static bool annuli_apart(const clod_case_region *a, const clod_case_region *b)
{
    const double off = hypot(a->center[0] - b->center[0], a->center[1] - b->center[1]);
    return off >= a->outer_radius + b->outer_radius ||
           off + a->outer_radius <= b->inner_radius || off + b->outer_radius <= a->inner_radius;
}

bool clod_region_overlap(const clod_case_region *a, const clod_case_region *b)
{
    double low[2][3], high[2][3];
    clod_region_bounds(a, low[0], high[0]);
    clod_region_bounds(b, low[1], high[1]);
    for (int k = 0; k < 3; k++) {
        if (high[0][k] <= low[1][k] || high[1][k] <= low[0][k]) {
            return false;
        }
    }
    return a->kind == CLOD_REGION_BOX || b->kind == CLOD_REGION_BOX || !annuli_apart(a, b);
}
