#pragma once
/**
 * @file crew.h
 * Processes side by side, each for a run that has not ended; for runs.c alone.
 */

#include "calibrate/runs.h"

/**
 * Run the rows [first, end) that have not ended. On a stop and on an error all processes are told to end, and
 * waited for.
 *
 * @param places  [points][parameters], in [0, 1]
 * Errors  CLOD_USAGE: clod run refuses a run, a case has changed, a folder in the way; CLOD_FAILED: a
 *         process is killed or lost, disk, memory; CLOD_INTERRUPTED.
 */
bool clod_crew_run(clod_runs *runs, size_t first, size_t end, const double *places,
                   clod_status *status);
