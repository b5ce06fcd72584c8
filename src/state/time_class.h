#pragma once
/**
 * @file time_class.h
 * Classes of times, 1 % wide: 240 a decade from 1 ms to 10^6 s. The first and the last one have
 * what is beyond too. For times that grains were in, and in clumps.
 */

#include <math.h>
#include <stdint.h>

#define CLOD_TIME_CLASSES 2160
#define CLOD_TIME_LEAST 1e-3 ///< s
#define CLOD_TIME_PER_DECADE 240

/** Class of a time [s]. Threads: pure. */
static inline int clod_time_class(double time)
{
    const double place =
        CLOD_TIME_PER_DECADE * log10(fmax(time, CLOD_TIME_LEAST) / CLOD_TIME_LEAST);
    return (int)fmin(place, CLOD_TIME_CLASSES - 1);
}

/** Lower end of a class [s]; that of CLOD_TIME_CLASSES is the upper end of the last one. */
static inline double clod_time_class_from(int k)
{
    return CLOD_TIME_LEAST * pow(10.0, (double)k / CLOD_TIME_PER_DECADE);
}

/**
 * Time that a fraction of all does not reach [s]: along the logarithm within its class, and
 * within the range of all, so right to 1 %, and of times that are the same that time.
 *
 * @param count     [CLOD_TIME_CLASSES]
 * @param all       sum of them, > 0
 * @param fraction  0 to 1
 * @param range     least and longest time [s]
 * Threads  pure.   Test  tests/state/test_time_class.c
 */
double clod_time_class_quantile(const int64_t *count, int64_t all, double fraction,
                                const double range[2]);
