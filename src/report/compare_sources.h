#pragma once
/**
 * @file compare_head.h
 * The warnings of compared runs, and where their results come from.
 */

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#include "clod/status.h"
#include "report/run_files.h"

/**
 * The warnings of all runs, each with the runs that have it: those that differ in their numbers alone are one.
 *
 * @param lab  the laboratory's results; NULL: none
 * Errors  CLOD_FAILED: no memory.   Test  tests/report/test_compare.py
 */
bool clod_compare_head_warnings(FILE *out, const clod_run_files *runs, size_t count,
                                const json_t *lab, clod_status *status);

/** Folder, version, time, seed and cost of each run. */
void clod_compare_head_sources(FILE *out, const clod_run_files *runs, size_t count);
