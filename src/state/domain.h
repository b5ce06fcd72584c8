#pragma once
/**
 * @file domain.h
 * The part of space that is simulated.
 */

#include <math.h>
#include <stdbool.h>

typedef struct clod_domain {
    double min[3], max[3]; ///< m
    bool periodic[3];
    bool removes; ///< a grain that leaves an open side is removed and counted; else it stops
                  ///< the run
} clod_domain;

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
