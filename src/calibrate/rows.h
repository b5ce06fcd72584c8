#pragma once
/**
 * @file rows.h
 * Rows of runs on the disk; for runs.c alone.
 */

#include "calibrate/runs.h"

/** Read the row of a run, if it is there; a state of none if not. Errors  CLOD_USAGE: damaged; CLOD_FAILED.
 */
bool clod_rows_read(const clod_runs *runs, size_t row, clod_runs_row *to, clod_status *status);

/** Write it. */
bool clod_rows_write(const clod_runs *runs, size_t row, clod_status *status);

/** Remove what a finished run does not need any more: checkpoints and snapshots. */
void clod_rows_trim(const clod_runs *runs, size_t row);

/** What a failed run said last: the rest of its log from its last "clod run:" on, in one line; owned, NULL
 *  without memory. */
char *clod_rows_last_words(const clod_runs *runs, size_t row);

/** Look whether the folder is of this plan, and mark it when it is new. */
bool clod_rows_mark(const clod_runs *runs, clod_status *status);
