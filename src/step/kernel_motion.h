#pragma once
/**
 * @file kernel_motion.h
 * Velocity Verlet on rows. Included by kernel.c only.
 *
 * Rows are treated whole: column 3 of a load row is zero, so radius, mass and inertia in the
 * last column of the other rows get +0 and stay.
 */

#include "step/kernel.h"

/** A row, and v2 and w2, as vectors of the compiler: the same in every set. */
typedef double kernel_row __attribute__((vector_size(32), may_alias));
typedef double kernel_pair __attribute__((vector_size(16)));
typedef int64_t kernel_pair_mask __attribute__((vector_size(16)));

/** Squares of a speed [m2/s2] or spin [1/s2] from here on count as not finite. */
#define KERNEL_INFINITE 1e60

/** v2 and w2 of a grain. */
__attribute__((always_inline)) static inline kernel_pair
kernel_squares(const kernel_row *velocity, const kernel_row *angular_velocity)
{
    const kernel_row v2 = *velocity * *velocity, w2 = *angular_velocity * *angular_velocity;
    const kernel_row xz = __builtin_shufflevector(v2, w2, 0, 4, 2, 6);
    const kernel_row y = __builtin_shufflevector(v2, w2, 1, 5, 3, 7);
    return __builtin_shufflevector(xz, xz, 0, 1) + __builtin_shufflevector(y, y, 0, 1) +
           __builtin_shufflevector(xz, xz, 2, 3);
}

/** The loop of kernel_drift; whether `gravity` is NULL is known where it is called. */
__attribute__((always_inline)) static inline clod_kernel_speed
kernel_drift_rows(double (*restrict position)[4], double (*restrict velocity)[4],
                  double (*restrict angular_velocity)[4], double (*restrict load)[8],
                  const double *gravity, double dt, size_t begin, size_t end)
{
    const kernel_row zero = {0.0, 0.0, 0.0, 0.0};
    const kernel_row step = {dt, dt, dt, 0.0};
    const kernel_pair limit = {KERNEL_INFINITE, KERNEL_INFINITE};
    const double half = 0.5 * dt;
    kernel_row fall = zero;
    if (gravity != NULL) {
        fall = (kernel_row){gravity[0], gravity[1], gravity[2], 0.0};
    }
    kernel_pair most = {0.0, 0.0};
    kernel_pair_mask finite = {-1, -1};
    for (size_t g = begin; g < end; g++) {
        kernel_row *const v = (kernel_row *)velocity[g];
        kernel_row *const w = (kernel_row *)angular_velocity[g];
        kernel_row *const p = (kernel_row *)position[g];
        kernel_row *const f = (kernel_row *)load[g];
        if (gravity != NULL) {
            f[0] += velocity[g][3] * fall;
        }
        const kernel_row push = half / velocity[g][3] * f[0];
        const kernel_row twist = half * angular_velocity[g][3] * f[1];
        if (gravity != NULL) { // the second half kick of the step before
            *v += push;
            *w += twist;
        }
        *v += push;
        *w += twist;
        *p += step * *v;
        f[0] = f[1] = zero;
        const kernel_pair squares = kernel_squares(v, w);
        const kernel_pair_mask more = squares > most;
        most = (kernel_pair)(((kernel_pair_mask)squares & more) |
                             ((kernel_pair_mask)most & ~more));
        finite &= squares < limit;
    }
    return (clod_kernel_speed){most[0], (finite[0] & finite[1]) != 0};
}

static clod_kernel_speed kernel_drift(double (*restrict position)[4],
                                      double (*restrict velocity)[4],
                                      double (*restrict angular_velocity)[4],
                                      double (*restrict load)[8], const double gravity[3],
                                      double dt, size_t begin, size_t end)
{
    if (gravity == NULL) {
        return kernel_drift_rows(position, velocity, angular_velocity, load, NULL, dt, begin,
                                 end);
    }
    return kernel_drift_rows(position, velocity, angular_velocity, load, gravity, dt, begin,
                             end);
}

static void kernel_kick(double (*restrict velocity)[4], double (*restrict angular_velocity)[4],
                        double (*restrict load)[8], const double gravity[3], double dt,
                        size_t begin, size_t end)
{
    const kernel_row fall = {gravity[0], gravity[1], gravity[2], 0.0};
    const double half = 0.5 * dt;
    for (size_t g = begin; g < end; g++) {
        kernel_row *const f = (kernel_row *)load[g];
        f[0] += velocity[g][3] * fall;
        *(kernel_row *)velocity[g] += half / velocity[g][3] * f[0];
        *(kernel_row *)angular_velocity[g] += half * angular_velocity[g][3] * f[1];
    }
}
