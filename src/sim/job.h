#pragma once
/**
 * @file job.h
 * The run loop: procedure, step, measure, output. One job is one state that is advanced by one
 * procedure and leaves one series, one set of snapshots and one pair of checkpoints.
 */

#include "clod/run.h"
#include "law/law.h"
#include "output/eventlog.h"
#include "state/state.h"

/** What decides what happens between steps; `data` is plain and goes into the checkpoint. */
typedef struct clod_procedure {
    void *data;
    size_t size;
    const void *context;
    const char *const *columns; ///< [column_count] of the series
    size_t column_count;
    int64_t (*plan)(const void *data, const void *context, const clod_state *state);
    /** Fill the row [column_count], change walls and adhesion; true when finished. */
    bool (*sample)(void *data, const void *context, clod_state *state, double *row);
    const char *(*phase)(const void *data, const void *context);
    double (*fraction)(const void *data, const void *context);
    /** Why it cannot go on, into `text`; false when it can. NULL when it always can. */
    bool (*trouble)(const void *data, char *text, size_t size);
} clod_procedure;

/** What all jobs of a run share; borrowed by them. */
typedef struct clod_sim {
    const clod_case *from;
    const clod_run_options *options;
    const char *directory;
    const char *identity; ///< of the case (sim/identity.h): checkpoints belong to it
    clod_eventlog *log;
} clod_sim;

#define CLOD_JOB_VERSION 128 ///< bytes of a version text

/** What a job remembers beside state and procedure; plain data. */
typedef struct clod_job_memory {
    int64_t finished;
    int64_t series_bytes, energy_bytes;
    int64_t snapshots;              ///< written so far
    double next_snapshot;           ///< s
    char version[CLOD_JOB_VERSION]; ///< of the clod that began the job
    int64_t planned;                ///< steps until the procedure looks again
    double wall_clock;              ///< s spent so far, over all interruptions; the last
                                    ///< member: beside its checksum in the file, so that tests
                                    ///< tell it from everything that must be the same
} clod_job_memory;

typedef struct clod_job {
    const clod_sim *sim;
    char name[48]; ///< also the start of its files' names
    int threads;
    clod_state state; ///< owned; made by the caller before clod_job_run
    clod_procedure procedure;
    clod_job_memory memory;
    bool resumed; ///< state and procedure come from a checkpoint
} clod_job;

/**
 * Fill state and procedure from the job's checkpoint if there is one.
 *
 * @param job  state with the walls of the case; procedure.data of the right size
 * @return     false when there is a checkpoint that cannot be used; job->resumed tells the rest
 */
bool clod_job_resume(clod_job *job, clod_status *status);

/**
 * Begin with the end of another job of this run instead of a state of its own.
 *
 * @param job   state with the walls of the case; procedure.data of the right size
 * @param name  of the finished job
 */
bool clod_job_begin_from(clod_job *job, const char *name, clod_status *status);

/**
 * Advance until the procedure is finished; does nothing when it already is.
 *
 * @return  false: CLOD_INTERRUPTED, or what went wrong. Checkpoints are written first; when
 *          physics has gone wrong the broken state goes to restart-NAME-failed instead.
 */
bool clod_job_run(clod_job *job, clod_status *status);

void clod_job_fini(clod_job *job);
