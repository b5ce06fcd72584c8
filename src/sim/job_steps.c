#include "sim/job_steps.h"

#include "clod/ranks.h"
#include "parallel/threads.h"
#include "setup/grains.h"

/** Grains that there will be at once, at most: those that are there, or are to come. */
static size_t most_grains(const clod_job *job)
{
    double expected = 0.0;
    clod_status ignored; // its sizes have been read before
    if (clod_setup_grains_coming(job->sim->from) > 0) {
        clod_setup_grains_expect(job->sim->from, 0.0, &expected, &ignored);
    }
    return job->state.grains.count + (size_t)expected;
}

int clod_job_threads(const clod_job *job)
{
    const clod_ranks *ranks = job->sim->options->ranks;
    if (!job->sim->any_threads) {
        return job->threads;
    }
    return ranks != NULL && clod_ranks_size(ranks) > 1
               ? 1
               : clod_threads_worth(job->threads, most_grains(job));
}

bool clod_job_see(const clod_job *job, clod_step *step, clod_status *status)
{
    const clod_procedure *p = &job->procedure;
    clod_sight sees = {.whole = p->sight == NULL};
    if (p->sight != NULL) {
        p->sight(p->data, p->context, &job->state, &sees);
    }
    return sees.whole
               ? clod_step_see(step, status)
               : sees.boxes == 0 || clod_step_see_near(step, sees.box, sees.boxes, status);
}
