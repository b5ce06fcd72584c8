#pragma once
/**
 * @file threads.h
 * How work is cut for threads: fixed, contiguous chunks. No result depends on the cut.
 */

#include <stddef.h>

/** Items [begin, end) of one part. */
typedef struct clod_chunk {
    size_t begin, end;
} clod_chunk;

/** Part number `part` of `parts` nearly equal chunks of `count` items. */
static inline clod_chunk clod_threads_chunk(size_t count, int part, int parts)
{
    const size_t p = (size_t)part;
    const size_t n = (size_t)parts;
    return (clod_chunk){count * p / n, count * (p + 1) / n};
}

/** Number of processors this process may use. */
int clod_threads_available(void);

/** Threads of a run that was asked for `wanted`, 0 = all: no more than there are processors,
 * since more only wait for each other. */
int clod_threads_take(int wanted);

/** Grains below which a further thread does not pay: it would wait more than compute. */
#define CLOD_THREADS_GRAINS 500

/** Of so many threads, those that pay for a bed of so many grains; at least one. */
int clod_threads_worth(int threads, size_t grains);

/**
 * Run `count` independent jobs on at most `workers` threads; job k starts before job k + 1.
 *
 * @param job      called once per job number
 * @param context  handed to every call
 * Errors  none: jobs keep their own.   Threads  blocks until all jobs have returned.
 */
void clod_threads_run(int count, int workers, void (*job)(void *context, int number),
                      void *context);
