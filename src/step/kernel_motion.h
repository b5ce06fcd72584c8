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
                                   double half)
{
    const double push = half / motion[3];
    const double twist = half * turning[3];
    for (int c = 0; c < 4; c++) {
        motion[c] += push * load[c];
    }
    for (int c = 0; c < 4; c++) {
        turning[c] += twist * load[4 + c];
    }
}

static clod_kernel_speed kernel_drift(double (*restrict place)[4], double (*restrict motion)[4],
                                      double (*restrict turning)[4], double (*restrict load)[8],
                                      double dt, size_t begin, size_t end)
{
    const double step[4] = {dt, dt, dt, 0.0};
    clod_kernel_speed seen = {0.0, true};
    for (size_t g = begin; g < end; g++) {
        kernel_kick_row(motion[g], turning[g], load[g], 0.5 * dt);
        for (int c = 0; c < 8; c++) {
            load[g][c] = 0.0;
        }
        for (int c = 0; c < 4; c++) {
            place[g][c] += step[c] * motion[g][c];
        }
        const double *v = motion[g];
        const double *w = turning[g];
        const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        const double w2 = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
        seen.max_speed2 = v2 > seen.max_speed2 ? v2 : seen.max_speed2;
        seen.finite &= v2 + w2 < 1e60;
    }
    return seen;
}

static void kernel_kick(double (*restrict motion)[4], double (*restrict turning)[4],
                        double (*restrict load)[8], const double gravity[3], double dt,
                        size_t begin, size_t end)
{
    const double g4[4] = {gravity[0], gravity[1], gravity[2], 0.0};
    for (size_t g = begin; g < end; g++) {
        const double mass = motion[g][3];
        for (int c = 0; c < 4; c++) {
            load[g][c] += mass * g4[c];
        }
        kernel_kick_row(motion[g], turning[g], load[g], 0.5 * dt);
    }
}
