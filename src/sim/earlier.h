#pragma once
/**
 * @file earlier.h
 * What an earlier run has left in the results folder, looked at before anything in it changes.
 */

#include "sim/job.h"

typedef enum clod_earlier {
    CLOD_EARLIER_REFUSED, ///< see the status
    CLOD_EARLIER_GO_ON,   ///< nothing is in the way: begin, or go on
    CLOD_EARLIER_DONE,    ///< the run is complete, but only its table can be told again
} clod_earlier;

/**
 * Whether there are checkpoints of a run, to go on from; a folder that is not there has none.
 *
 * Errors  CLOD_FAILED: the folder is there and cannot be read.
 */
bool clod_earlier_has_checkpoints(const char *directory, bool *found, clod_status *status);

/**
 * Refuse to go on with another case before its copies in the folder are replaced (checkpoints
 * know their case too; this is for the copies), and refuse to begin anew over results whose
 * checkpoints are gone: only --fresh does that.
 *
 * @param complete  the complete case of now
 * @param report    [out] owned text when the answer is CLOD_EARLIER_DONE
 * Errors  CLOD_USAGE: another case, checkpoints gone; CLOD_FAILED: cannot be read.
 * Threads one per folder.   Test  tests/cli/test_folder.py
 */
clod_earlier clod_earlier_look(const clod_job_shared *sim, const char *complete, char **report,
                               clod_status *status);
