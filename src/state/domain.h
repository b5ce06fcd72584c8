#pragma once
/**
 * @file domain.h
 * The part of space that is simulated.
 */

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/** A region, in which grains are removed or measured: a box, or with an outer radius what of the
 *  box is between two radii from an upright axis. */
typedef struct clod_outlet {
    double low[3], high[3]; ///< m
    double middle[2];       ///< m, x and y of the axis
    double inner, outer;    ///< m; outer 0: all of the box
} clod_outlet;

/** A box along the axes [m]. */
typedef struct clod_domain_box {
    double low[3], high[3];
} clod_domain_box;

#define CLOD_OUTLETS 8
#define CLOD_OUTLET_NUMBERS 10 ///< doubles of an outlet

typedef struct clod_domain {
    double min[3], max[3]; ///< m
    bool periodic[3];
    bool removes; ///< a grain that leaves an open side is removed and counted; else it stops
                  ///< the run
    int32_t outlets;
    clod_outlet outlet[CLOD_OUTLETS];
} clod_domain;

/** Whether a point is in a region, its border included: the one test of this. Threads: pure. */
static inline bool clod_outlet_has(const clod_outlet *self, const double p[3])
{
    bool in = true;
    for (int a = 0; a < 3; a++) {
        in = in && p[a] >= self->low[a] && p[a] <= self->high[a];
    }
    const double x = p[0] - self->middle[0], y = p[1] - self->middle[1];
    const double r2 = x * x + y * y;
    return in && (self->outer == 0.0 ||
                  (r2 >= self->inner * self->inner && r2 <= self->outer * self->outer));
}

/** The first outlet that a point is in, or -1. Threads: pure. */
static inline int clod_domain_outlet(const clod_domain *self, const double p[3])
{
    for (int32_t k = 0; k < self->outlets; k++) {
        if (clod_outlet_has(&self->outlet[k], p)) {
            return (int)k;
        }
    }
    return -1;
}

/** A position along one axis [m], in a periodic direction that within [min, max), and the number of
 *  periods it is away from there. Threads: pure. */
static inline double clod_domain_unwind(const clod_domain *self, int axis, double at,
                                        double *turns)
{
    const double low = self->min[axis], high = self->max[axis], period = high - low;
    *turns = 0.0;
    if (!self->periodic[axis] || (at >= low && at < high)) {
        return at;
    }
    *turns = floor((at - low) / period);
    const double within = at - period * *turns;
    if (within >= high) { // by rounding alone: it is at the beginning of the next period
        *turns += 1.0;
    }
    return within >= low && within < high ? within : low;
}

/** A position along one axis [m], in a periodic direction that within [min, max): grains are a
 *  little outside until the neighbour list is next made. Threads: pure. */
static inline double clod_domain_within(const clod_domain *self, int axis, double at)
{
    double turns;
    return clod_domain_unwind(self, axis, at, &turns);
}

/** Where a grain is in the domain: what asks whether it is in a region asks with this.
 *
 *  @param position  [4] m, with the radius
 *  @param place     [4] [out]
 *  Threads  pure. */
static inline void clod_domain_place(const clod_domain *self, const double position[4],
                                     double place[4])
{
    for (int a = 0; a < 3; a++) {
        place[a] = clod_domain_within(self, a, position[a]);
    }
    place[3] = position[3];
}

/** a - b along one axis, by the nearest image where the domain is periodic [m]. */
static inline double clod_domain_separation(const clod_domain *self, int axis, double a,
                                            double b)
{
    const double s = a - b;
    if (!self->periodic[axis]) {
        return s;
    }
    const double period = self->max[axis] - self->min[axis];
    return s - period * nearbyint(s * (1.0 / period));
}
