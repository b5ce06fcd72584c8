#pragma once
/**
 * @file clock.h
 * Time on clocks that only go forward [s]; since when is not said. And the date. Threads  any.
 */

#include <stdio.h>
#include <time.h>

enum { CLOD_CLOCK_TEXT = 64 };

/** The moment, UTC with milliseconds: 2026-11-28T03:02:11.250Z. */
static inline void clod_clock_date(char text[CLOD_CLOCK_TEXT])
{
    struct timespec now;
    struct tm parts;
    char day[40];
    clock_gettime(CLOCK_REALTIME, &now);
    gmtime_r(&now.tv_sec, &parts);
    strftime(day, sizeof day, "%Y-%m-%dT%H:%M:%S", &parts);
    snprintf(text, CLOD_CLOCK_TEXT, "%s.%03dZ", day, (int)(now.tv_nsec / 1000000));
}

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
