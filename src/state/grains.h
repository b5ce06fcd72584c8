#pragma once
/**
 * @file grains.h
 * Spherical grains as rows of 32 bytes, in the order in which forces are summed.
 *
 * Two rows beyond `count` always exist and never touch anything: the padding of contact blocks.
 */

#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"

/** The clump that a grain is in (docs/clumps.md). */
typedef struct clod_grain_clump {
    uint64_t number; ///< id of its first grain, 0: none; when it was last shown or looked at
    double since;    ///< s, first look of those without a break that saw it in one; < 0: none
    int32_t size;    ///< grains, with `number`
    int32_t seen;    ///< the same at the last look
} clod_grain_clump;

/** Of a grain that is in none. */
#define CLOD_GRAIN_CLUMP_NONE ((clod_grain_clump){.since = -1.0})

typedef struct clod_grains {
    size_t count;
    size_t capacity;               ///< rows allocated, at least count + 2
    double (*position)[4];         ///< x, y, z [m], radius [m]
    double (*velocity)[4];         ///< vx, vy, vz [m/s], mass [kg]
    double (*angular_velocity)[4]; ///< wx, wy, wz [rad/s], 1/moment of inertia [1/(kg m2)]
    double (*load)[8];   ///< Fx, Fy, Fz [N], 0, Tx, Ty, Tz [N m], 0: sums of the last step
    double (*before)[8]; ///< while a step adds up loads, those of the step before; NULL unless
                         ///< somebody asked for it (the energy ledger)
    uint64_t *id;        ///< global, never changes
    double *birth;       ///< s, time at which it came; 0: it was there at the start
    uint16_t *material;
    clod_grain_clump *clump; ///< NULL unless somebody asked for it
} clod_grains;

/** Reserve rows for at least `count` grains; keeps what is there. */
bool clod_grains_reserve(clod_grains *self, size_t count, clod_status *status);

/** Give a row a radius [m]; mass and inertia follow with the density [kg/m3]. */
void clod_grains_set_size(clod_grains *self, size_t row, double radius, double density);

/**
 * Append one grain; mass and inertia follow from radius and density.
 *
 * @param position  [4] x, y, z, radius [m]
 * @param speed  [3] m/s
 * @param spin   [3] rad/s
 */
bool clod_grains_add(clod_grains *self, const double position[4], const double speed[3],
                     const double spin[3], double density, uint16_t material, uint64_t id,
                     clod_status *status);

/** From now on keep the loads of the step before. */
bool clod_grains_keep_before(clod_grains *self, clod_status *status);

/** From now on know the clump of each grain; in none at first. */
bool clod_grains_keep_clumps(clod_grains *self, clod_status *status);

/** Rows from `first` on as grains of their own, in which nothing is owned. Threads: pure. */
clod_grains clod_grains_view(const clod_grains *self, size_t first, size_t count);

/** Put the two padding rows behind the last grain. */
void clod_grains_pad(clod_grains *self);

/** Deep copy into an empty set. */
bool clod_grains_copy(clod_grains *self, const clod_grains *from, clod_status *status);

void clod_grains_fini(clod_grains *self);
