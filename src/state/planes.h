#pragma once
/**
 * @file planes.h
 * Counting planes: every grain whose centre passes one is counted, forward and back
 * (docs/adr/0047).
 */

#include <stdint.h>

#include "parallel/exact.h"
#include "state/domain.h"

/** Most planes. */
#define CLOD_PLANES 16

/** A plane at right angles to an axis of space. A centre on it is beyond it, as seen along the axis. */
typedef struct clod_plane {
    clod_outlet region; ///< a centre that passes the plane outside of it does not count
    double at;          ///< m, along the axis
    int32_t axis;
    int32_t sign; ///< 1: forward is along the axis; -1: against it
} clod_plane;

/** Ways through a plane. */
enum { CLOD_PASSED_FORWARD, CLOD_PASSED_BACK, CLOD_PASSED_WAYS };

/** What has passed a plane; all zero: nothing. */
typedef struct clod_passed {
    int64_t grains[CLOD_PASSED_WAYS];
    clod_exact mass[CLOD_PASSED_WAYS]; ///< kg
} clod_passed;

typedef struct clod_planes {
    int32_t count;
    clod_plane plane[CLOD_PLANES];
    clod_passed passed[CLOD_PLANES]; ///< since the beginning
} clod_planes;

/**
 * How many times a coordinate has passed a plane, from an origin of its own: the difference of two
 * levels is the number of passages on the way between them. In a periodic direction a plane has an image in each
 * period. Whether a grain is put back into the domain in between, as a rebuild does, changes a level by a whole number of
 * periods and nothing else, rounding included.
 *
 * @param x  m, along the axis of the plane
 * Threads  pure.   Test  tests/step/test_passages.c
 */
static inline double clod_plane_level(const clod_plane *self, const clod_domain *domain,
                                      double x)
{
    double turns;
    const double within = clod_domain_unwind(domain, self->axis, x, &turns);
    return turns + (within >= self->at ? 1.0 : 0.0);
}
