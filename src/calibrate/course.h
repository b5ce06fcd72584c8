#pragma once
/**
 * @file course.h
 * What a budget has bought is decided once and kept in the folder (course.json): the runs side by side that
 * its time was counted with. So the number of points is a function of plan, rows and this file.
 */

#include "calibrate/runs.h"

/** The workers that this plan's budget is counted with: those of the folder, else those of this call.
 *  Errors  CLOD_USAGE: damaged; CLOD_FAILED: disk, memory. */
bool clod_course_read(clod_runs *runs, clod_status *status);

/** Keep them, once the budget is found to be large enough. */
bool clod_course_write(const clod_runs *runs, clod_status *status);
