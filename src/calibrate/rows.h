#pragma once
/**
 * @file rows.h
 * Rows of runs on the disk; for runs.c and crew.c alone.
 */

#include "calibrate/runs.h"

/** What a run is made with, "seed=3; contacts.default.friction=0.4": a row of other settings is none. Owned,
 *  NULL without memory. */
char *clod_rows_settings(const clod_plan *plan, size_t row, const double *places);

/** Read the row of a run, if it is there with the settings that `to` has; a state of none if not.
 *  Errors  CLOD_USAGE: damaged; CLOD_FAILED. */
bool clod_rows_read(const clod_runs *runs, size_t row, clod_runs_row *to, clod_status *status);

/** Write it. */
bool clod_rows_write(const clod_runs *runs, size_t row, clod_status *status);

/** Remove it, so that the run begins anew. */
void clod_rows_forget(const clod_runs *runs, size_t row);

/** Whether a process has locked a run's folder. */
bool clod_rows_in_use(const char *folder);

/**
 * Make a run's folder ready: go on in one that was begun with these settings, its time so far added up;
 * empty one of other settings. Its row is written as begun.
 * Errors  CLOD_USAGE: the folder is in use, or someone else's; CLOD_FAILED.
 */
bool clod_rows_begin(const clod_runs *runs, size_t row, clod_status *status);

/** Remove what a finished run does not need any more: CLOD_FOLDER_SPARE. */
void clod_rows_trim(const clod_runs *runs, size_t row);

/** What a failed run said last: the rest of its log from its last "clod run:" on, in one line; owned, NULL
 *  without memory. */
char *clod_rows_last_words(const clod_runs *runs, size_t row);

/** Look whether the folder is of this plan, and mark it when it is new.
 *  Errors  CLOD_USAGE: of another plan, with the first line that differs; CLOD_FAILED. */
bool clod_rows_mark(const clod_runs *runs, clod_status *status);

/** Look whether a folder that may not be there is of this plan; the folder of `runs` is not read. Errors  as above. */
bool clod_rows_look(const clod_runs *runs, const char *directory, clod_status *status);
