#pragma once
/**
 * @file job.h
 * The run loop: procedure, step, measure, output. One job is one state that is advanced by one
 * procedure and leaves one series, one set of snapshots and one pair of checkpoints.
 */

#include "clod/run.h"
#include "law/law.h"
#include "measure/contacts.h"
#include "output/eventlog.h"
#include "output/folder.h"
#include "output/series.h"
#include "output/snapshot.h"
#include "sim/frame.h"
#include "sim/news.h"
#include "sim/sight.h"
#include "sim/time_limit.h"
#include "state/state.h"
#include "step/crew_deal.h"

/** What decides what happens between steps; `data` is plain and goes into the checkpoint. */
typedef struct clod_procedure {
    void *data;
    size_t size;          ///< bytes of `data`
    size_t measures_size; ///< bytes behind them: what measures remember; 0: there are none
    const void *context;
    const char *const *columns; ///< [column_count] of the series
    size_t column_count;
    /** Before every plan: ask for grains to come (state->changes), or measure. NULL: nothing. */
    bool (*act)(void *data, const void *context, clod_state *state, const clod_survey *survey,
                clod_status *status);
    /** After every act: the next thing to be said at once; false: nothing more. NULL: nothing. */
    bool (*news)(void *data, const void *context, const clod_state *state, clod_news *news);
    int64_t (*plan)(const void *data, const void *context, const clod_state *state);
    /** After the planned steps: what look, sample and then act must see of the bed in the state, and not
     *  by asking the survey; walls and numbers are there anyhow. NULL: all of it. */
    void (*sight)(const void *data, const void *context, const clod_state *state,
                  clod_sight *sees);
    /** After the planned steps: whether it is time for a sample. NULL: it always is. */
    bool (*look)(void *data, const void *context, const clod_state *state,
                 const clod_survey *survey);
    /** Before a sample: measure what may fail. NULL: nothing. */
    bool (*measure)(void *data, const void *context, clod_state *state,
                    const clod_survey *survey, clod_status *status);
    /** Fill the row [column_count], change walls and adhesion; true when finished. */
    bool (*sample)(void *data, const void *context, clod_state *state,
                   const clod_survey *survey, double *row);
    /** Before a snapshot: have the columns of grains that it shows filled, wherever these are, and write
     *  what is shown beside it. NULL: nothing. */
    bool (*picture)(void *data, const void *context, clod_state *state,
                    const clod_survey *survey, const clod_frame *frame, clod_status *status);
    /** Write files at the end, of measures; again when a job that is finished is gone on with. NULL:
     *  nothing. */
    bool (*write)(const void *data, const void *context, clod_state *state,
                  const clod_frame *frame, clod_status *status);
    const char *(*phase)(const void *data, const void *context);
    /** Name of a phase by its number in the series, NULL: there is none. NULL: nobody asks. */
    const char *(*phase_name)(int phase);
    double (*fraction)(const void *data, const void *context);
    /** Why the phase that a sample has just ended is over. NULL: nobody asks. */
    const char *(*reason)(const void *data);
    /** Why it cannot go on, into `text`; false when it can. NULL when it always can. */
    bool (*trouble)(const void *data, char *text, size_t size);
} clod_procedure;

/** What all jobs of a run share; borrowed by them. */
typedef struct clod_job_shared {
    const clod_case *from;
    const clod_run_options *options;
    const char *directory;     ///< path of the folder, for messages
    const clod_folder *folder; ///< open and locked
    const char *identity;      ///< of the case (sim/identity.h): checkpoints belong to it
    clod_eventlog *log;
    struct clod_origin *origin; ///< run from whose grains this one begins; NULL: none
    struct clod_group *group;   ///< of ranks, beside others (sim/group.h); NULL: there is one
    clod_time_limit limit;
    bool any_threads; ///< nobody asked for a number: no more than pay
} clod_job_shared;

#define CLOD_JOB_VERSION 128 ///< bytes of a version text
#define CLOD_JOB_ORIGIN 512  ///< bytes of an origin

/** What a job remembers beside state and procedure; plain data. */
typedef struct clod_job_memory {
    int64_t finished;
    clod_series_mark series, energy, leavers; ///< at the checkpoint
    int64_t snapshots;                        ///< written so far
    clod_snapshot_film film;                  ///< at the checkpoint
    char version[CLOD_JOB_VERSION];           ///< of the clod that began the job
    char origin[CLOD_JOB_ORIGIN]; ///< run from whose grains it began (sim/origin.h); "": none
    int64_t planned;              ///< steps until the procedure looks again
    double wall_clock;            ///< s spent so far, over all interruptions; the last
                                  ///< member: beside its checksum in the file, so that tests
                                  ///< tell it from everything that must be the same
} clod_job_memory;

typedef struct clod_job {
    const clod_job_shared *sim;
    char name[48]; ///< also the start of its files' names
    int threads;
    clod_state state; ///< owned; made by the caller before clod_job_run
    clod_procedure procedure;
    clod_job_memory memory;
    bool dealt;                ///< of several ranks: each has its share of the bed (sim/deal.h)
    clod_crew_share share;     ///< then that of rank 0 beside the state; owned
    bool resumed;              ///< state and procedure come from a checkpoint
    clod_measure_contacts bed; ///< at the end of the steps, as the next
    clod_measure_motion motion;
    double stable_step; ///< s, measured last (clod_job_stable_step) ...
    int64_t stable_at;  ///< ... at this step
    bool stable_known;  ///< ... if it was
    bool stepped;       ///< there were steps; else the state is that of the end
} clod_job;

/**
 * Fill state and procedure from the job's checkpoint if there is one.
 *
 * @param job  state with the walls of the case; procedure.data of the right size
 * @return     false when there is a checkpoint that cannot be used; job->resumed tells the rest
 */
bool clod_job_resume(clod_job *job, clod_status *status);

/**
 * Begin with the end of another job of this run instead of a state of its own; grains that were
 * another run's (memory.origin) still are.
 *
 * @param job   state with the walls of the case; procedure.data of the right size
 * @param name  of the finished job
 */
bool clod_job_begin_from(clod_job *job, const char *name, clod_status *status);

/**
 * Take the finished job of this name from the run that this one begins from, with its tables.
 *
 * The checkpoint that a kill on the way leaves has the state of before: then it is taken over
 * again, or run without --from. The caller stores the one of after.
 *
 * @param job  as it would begin by itself
 */
bool clod_job_take_over(clod_job *job, clod_status *status);

/**
 * Whether it can be taken over; nothing is written.
 *
 * @param job  as it would begin by itself; its state is the other one's afterwards
 * Errors  CLOD_USAGE: no checkpoint that can be read, not finished, too long a time step, a
 *         table that is not what it was.
 */
bool clod_job_try_origin(clod_job *job, clod_status *status);

/**
 * Advance until the procedure is finished; does nothing when it already is.
 *
 * @return  false: CLOD_INTERRUPTED, or what went wrong. Checkpoints are written first; when
 *          physics has gone wrong the broken state goes to restart-NAME-failed instead.
 */
bool clod_job_run(clod_job *job, clod_status *status);

/** What the contacts say at the end of a job that has run. */
clod_measure_contacts clod_job_bed(const clod_job *job);

/** How its grains move then. */
clod_measure_motion clod_job_motion(const clod_job *job);

/** The largest stable time step of its bed then [s] (setup/stability.h); 0: not known, or
 *  nothing that could swing. */
double clod_job_stable_step(const clod_job *job);

void clod_job_fini(clod_job *job);
