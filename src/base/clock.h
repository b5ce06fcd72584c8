#pragma once
/**
 * @file clock.h
 * Time on clocks that only go forward [s]; since when is not said. Threads  any.
 */

#include <time.h>

static inline double clod_clock_read(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static inline double clod_clock_now(void)
{
    return clod_clock_read(CLOCK_MONOTONIC);
}

/** What the calling thread has had of a processor. */
static inline double clod_clock_worked(void)
{
    return clod_clock_read(CLOCK_THREAD_CPUTIME_ID);
}
