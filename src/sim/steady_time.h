#pragma once
/**
 * @file steady_time.h
 * The part of a free run over which all means of its report are taken (output.steady_since):
 * those of gauges, fields, mixing indices, angles of repose, belts, balance, clumps, build-up,
 * history map and surfaces. It is cut into
 * blocks: their scatter is that of the means.
 */

#include <stdint.h>

#include "clod/case.h"

#define CLOD_STEADY_BLOCKS 10

/** From a time to the last step of the stages, which is the one nearest to their end. */
typedef struct clod_steady_time {
    double since; ///< s, of simulated time
    double block; ///< s
} clod_steady_time;

/**
 * The steady time of a case.
 *
 * @param begin  s, time at which the run began;  @param dt  s
 * Threads  pure.   Test  tests/sim/test_steady_time.c
 */
clod_steady_time clod_steady_time_of(const clod_case *from, double begin, double dt);

/**
 * Steps from a time to a moment of the steady time; 0 in the first step at it or behind it.
 *
 * @param moment  s;  @param time  s, now;  @param dt  s
 * Threads  pure.   Test  tests/sim/test_steady_time.c
 */
int64_t clod_steady_time_steps(double moment, double time, double dt);

/** Time of an interval that is in the steady time [s]; 0 when it ended before. Threads: pure. */
double clod_steady_time_within(const clod_steady_time *self, double from, double to);

/** Block edges that are behind a time: 0 before the first block, CLOD_STEADY_BLOCKS + 1 at the
 *  end of the last one. Threads: pure. */
int clod_steady_time_edges(const clod_steady_time *self, double time);

/** Block that a time is in, or -1 before the first; the end belongs to the last. */
int clod_steady_time_block(const clod_steady_time *self, double time);

/** Standard deviation of the values that are not NAN; NAN with fewer than two. Threads: pure. */
double clod_steady_time_deviation(const double *values, int count);
