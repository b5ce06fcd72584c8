#pragma once
/**
 * @file job_store.h
 * What a job leaves in the results folder and finds there: checkpoints and snapshots. Jobs run
 * side by side in threads, and HDF5 is not thread-safe: they take turns here.
 */

#include "sim/job.h"
#include "state/bed_source.h"

#define CLOD_JOB_STEM 96 ///< bytes: restart-, the name of a part and a suffix

/** Whether it is the only job of a free run: its files have plain names, others their own. */
bool clod_job_is_plain(const clod_job *self);

/** Start of the names of a job's checkpoints; `suffix` is "" for those to go on from. */
void clod_job_stem(const char *name, const char *suffix, char stem[CLOD_JOB_STEM]);

/** Names of the tables of a job: its series, and the energies of the ledger. */
void clod_job_table_names(const char *name, char series[CLOD_JOB_STEM],
                          char energy[CLOD_JOB_STEM]);

/** Tell the user a sentence, and the log. */
void clod_job_tell(const clod_job *self, const char *text);

/** Write a checkpoint; `bed` NULL: it is in the state. */
bool clod_job_store(clod_job *self, const clod_bed_source *bed, const char *suffix,
                    clod_status *status);

/** Write the next snapshot. With lines of contacts the state has all grains and contacts. */
bool clod_job_picture(clod_job *self, const clod_survey *survey, const clod_bed_source *bed,
                      clod_status *status);

/** Write the files that the procedure has at the end. */
bool clod_job_write_files(clod_job *self, clod_status *status);

/** Forget the snapshots that are later than the state. */
bool clod_job_cut_pictures(const clod_job *self, clod_status *status);
