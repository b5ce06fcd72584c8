#pragma once
/**
 * @file compare_free.h
 * The table of a comparison of free runs.
 */

#include <jansson.h>
#include <stdbool.h>

#include "report/run_files.h"
#include "report/writer.h"

/**
 * What all free runs have, and the angles of repose, mixing indices and mass flows that any of them measured.
 *
 * @param lab  NULL: no laboratory stands beside them
 * Errors  CLOD_FAILED: no memory.   Test  tests/report/test_compare.py
 */
bool clod_compare_free_results(clod_writer out, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status);
