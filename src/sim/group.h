#pragma once
/**
 * @file group.h
 * Parts of a test on groups of ranks: each group steps some of the parts of a batch, one after the
 * other, all groups at the same time. Rank 0 leads the first group; the first rank of every other one
 * has the jobs of that group's parts, writes their files, and hears from rank 0 what to do. What it knows
 * of its parts in the end, and what it has to tell, goes to rank 0.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.   Test  tests/sim/test_group.c,
 * test_run_ranks.c, tests/parallel/test_mpirun_groups.py, test_mpirun_from.py
 */

#include "base/bytes.h"
#include "clod/run.h"
#include "parallel/ranks.h"
#include "sim/parts.h"

/** A group, as its first rank knows it. */
typedef struct clod_group {
    clod_ranks *all;               ///< borrowed
    clod_ranks ranks;              ///< of this group
    int number, count;             ///< of this group, and how many there are
    const clod_run_options *asked; ///< of rank 0, whose signals all hear; else NULL
    bool stopped;                  ///< rank 0: it has told the others to stop
    int saved;                     ///< rank 0: the last request to save that it has told
    int working;                   ///< rank 0: groups that have not said that they are done
    bool ended;                    ///< others: rank 0 has nothing more to say
    bool failed;                   ///< a part of any group has: no further one is begun
    bool told_failed;              ///< rank 0: the others know; others: rank 0 does
    clod_run_signal stop, save;    ///< others: what they were told
} clod_group;

/** How many groups step so many parts best: no more than a fifth of their time is nobody's. */
int clod_group_best(int ranks, int parts);

/** The same of these ranks; 1 where they cannot be split. */
int clod_group_count(const clod_ranks *all, int parts);

/**
 * Run a batch on groups. Threads: rank 0, the others serve.
 *
 * @param part  [count] results are there in the end, also of those that failed
 * @return      false: no part could be begun at all
 */
bool clod_group_run(const clod_parts_tester *tester, const clod_job_shared *sim,
                    clod_part *part, int count, int groups, clod_status *status);

/** Rank 0 has said that parts follow: take one's share. Threads: all ranks but 0. */
void clod_group_serve(clod_ranks *all);

/** Hear what others have to say; NULL is fine. */
void clod_group_hear(clod_group *self);
