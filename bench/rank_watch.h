#pragma once
/**
 * @file rank_watch.h
 * What this rank does between two steps of a run under mpirun: its work, its waiting, and what it
 * sends. Looked at where ghosts are sent, once in each step; that costs a comparison.
 */

#include "parallel/ranks.h"

/** Of this rank, from the sending of ghosts of one step to that of another. */
typedef struct bench_rank_watched {
    int64_t steps;                 ///< between them
    double wall;                   ///< s
    double worked;                 ///< s of processor time of thread 0 outside of messages
    clod_ranks_count count;        ///< in that time
    int64_t ghosts_in, ghosts_out; ///< bytes of a step, at its end
    int neighbours;                ///< ranks that they go to
} bench_rank_watched;

/** Watch from step `first` on, that is the one in which ghosts are sent for the first + 1st time, until
 *  the last of so many more. One watch in a process. */
void bench_rank_watch(clod_ranks *ranks, int64_t first, int64_t steps);

/** What was seen; all zero before the end. */
bench_rank_watched bench_rank_seen(void);

/** Its members, as a part of a line of JSON, to stdout. */
void bench_rank_print(const bench_rank_watched *seen);
