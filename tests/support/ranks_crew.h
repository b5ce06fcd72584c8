#pragma once
/**
 * @file ranks_crew.h
 * Ranks of which the first has the job, and the others wait for its orders.
 */

#include "step/crew.h"
#include "support/ranks_threads.h"

typedef struct ranks_job {
    void (*run)(void *context, clod_ranks *ranks);
    void *context;
} ranks_job;

static inline void ranks_crew_rank(clod_ranks *ranks, void *context)
{
    const ranks_job *job = context;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    job->run(job->context, ranks);
    clod_crew_dismiss(ranks);
}

/** Run a job on rank 0 of so many, of a crew that ends with it. */
static inline void ranks_crew_run(int size, void (*run)(void *context, clod_ranks *ranks),
                                  void *context)
{
    ranks_job job = {run, context};
    ranks_run(size, ranks_crew_rank, &job);
}
