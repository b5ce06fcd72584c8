#pragma once
/**
 * @file job_tables.h
 * The tables that a job writes as it goes on: its series, the energies of the ledger, the grains
 * that left. A checkpoint notes how far each is; a job that goes on cuts them there.
 */

#include "sim/job.h"

/** Tables of a job; those that nobody wants are NULL. */
typedef struct clod_job_tables {
    clod_series *series, *energy, *leavers;
} clod_job_tables;

/** Open the tables that the case wants: new, or where the job's checkpoint has left them. */
bool clod_job_tables_open(clod_job_tables *self, clod_job *job, clod_status *status);

/** Append the grains that have left since the last call. */
bool clod_job_tables_leavers(clod_job_tables *self, clod_job *job, clod_status *status);

/** Bring all to the disk, and note in the job how far each is. */
bool clod_job_tables_mark(clod_job_tables *self, clod_job *job, clod_status *status);

/**
 * Close all.
 *
 * @param ok  whether all went well so far; else `status` has the error to report and stays
 * @return    ok, and all closed without error
 */
bool clod_job_tables_close(clod_job_tables *self, bool ok, clod_status *status);
