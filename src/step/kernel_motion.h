#pragma once
/**
 * @file kernel_motion.h
 * Velocity Verlet on rows. Included by kernel.c only.
 *
 * Rows are treated whole: column 3 of a load row is zero, so radius, mass and inertia in the
 * last column of the other rows get +0 and stay.
 */

#include <math.h>

#include "step/kernel.h"

static inline void kernel_kick_row(double motion[4], double turning[4], const double load[8],
                                   double push, double twist)
{
    for (int c = 0; c < 4; c++) {
        motion[c] += push * load[c];
    }
    for (int c = 0; c < 4; c++) {
        turning[c] += twist * load[4 + c];
    }
}

static inline void kernel_weigh(double load[8], double mass, const double gravity[4])
{
    for (int c = 0; c < 4; c++) {
        load[c] += mass * gravity[c];
    }
}

static inline double kernel_square(const double v[4])
{
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

/** The loop of kernel_drift; whether `gravity` is NULL is known where it is called. */
__attribute__((always_inline)) static inline clod_kernel_speed
kernel_drift_rows(double (*restrict place)[4], double (*restrict motion)[4],
                  double (*restrict turning)[4], double (*restrict load)[8],
                  const double gravity[4], double dt, size_t begin, size_t end)
{
    const double step[4] = {dt, dt, dt, 0.0};
    const double half = 0.5 * dt;
    clod_kernel_speed seen = {0.0, true};
    for (size_t g = begin; g < end; g++) {
        const double push = half / motion[g][3];
        const double twist = half * turning[g][3];
        if (gravity != NULL) {
            kernel_weigh(load[g], motion[g][3], gravity);
            kernel_kick_row(motion[g], turning[g], load[g], push, twist);
        }
        kernel_kick_row(motion[g], turning[g], load[g], push, twist);
        for (int c = 0; c < 8; c++) {
            load[g][c] = 0.0;
        }
        for (int c = 0; c < 4; c++) {
            place[g][c] += step[c] * motion[g][c];
        }
        const double v2 = kernel_square(motion[g]);
        const double w2 = kernel_square(turning[g]);
        seen.max_speed2 = v2 > seen.max_speed2 ? v2 : seen.max_speed2;
        seen.finite &= v2 + w2 < 1e60;
    }
    return seen;
}

static clod_kernel_speed kernel_drift(double (*restrict place)[4], double (*restrict motion)[4],
                                      double (*restrict turning)[4], double (*restrict load)[8],
                                      const double gravity[3], double dt, size_t begin,
                                      size_t end)
{
    if (gravity == NULL) {
        return kernel_drift_rows(place, motion, turning, load, NULL, dt, begin, end);
    }
    const double g4[4] = {gravity[0], gravity[1], gravity[2], 0.0};
    return kernel_drift_rows(place, motion, turning, load, g4, dt, begin, end);
}

static void kernel_kick(double (*restrict motion)[4], double (*restrict turning)[4],
                        double (*restrict load)[8], const double gravity[3], double dt,
                        size_t begin, size_t end)
{
    const double g4[4] = {gravity[0], gravity[1], gravity[2], 0.0};
    for (size_t g = begin; g < end; g++) {
        kernel_weigh(load[g], motion[g][3], g4);
        kernel_kick_row(motion[g], turning[g], load[g], 0.5 * dt / motion[g][3],
                        0.5 * dt * turning[g][3]);
    }
}
