#pragma once
/**
 * @file compare_keys.h
 * In which keys the cases of compared runs differ.
 */

#include <stdbool.h>
#include <stdio.h>

#include "report/run_files.h"

/** A table of the keys whose values are not the same in all cases. Errors  CLOD_FAILED: no memory. */
bool clod_compare_keys_put(FILE *out, const clod_run_files *runs, size_t count,
                           clod_status *status);
