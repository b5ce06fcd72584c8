#pragma once
/**
 * @file compare_tables.h
 * Tables of a comparison: a row for each run.
 */

#include <jansson.h>
#include <stdio.h>

#include "report/run_files.h"

/** The results of all runs, and of the laboratory (NULL: none), a row each. */
void clod_compare_tables_results(FILE *out, const clod_run_files *runs, size_t count,
                                 const json_t *lab);

/** The keys whose values are not the same in all cases. Errors  CLOD_FAILED: no memory. */
bool clod_compare_tables_keys(FILE *out, const clod_run_files *runs, size_t count,
                              clod_status *status);
