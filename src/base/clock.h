#pragma once
/**
 * @file clock.h
 * Time on a clock that only goes forward [s]; since when is not said. Threads  any.
 */

#include <time.h>

static inline double clod_clock_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
