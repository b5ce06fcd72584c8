#pragma once
/**
 * @file cases.h
 * The cases of a calibration, as the disk has them: one that changes between two runs would make results of
 * different things.
 */

#include "calibrate/runs.h"

/**
 * All that a test's runs depend on but their settings: its complete case in the middle of all ranges, with
 * what it includes, and hashes of the files that it names.
 *
 * @return  owned (clod_memory_free), or NULL
 * Errors  CLOD_USAGE: the case or a file of it; CLOD_FAILED: disk, memory.
 */
char *clod_cases_describe(const clod_plan *plan, size_t test, clod_status *status);

/** Whether the disk still has the case that the calibration began with.
 *  Errors  CLOD_USAGE: it has changed; as clod_cases_describe. */
bool clod_cases_same(const clod_runs *runs, size_t test, clod_status *status);
