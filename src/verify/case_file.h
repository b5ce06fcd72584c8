#pragma once
/**
 * @file case_file.h
 * The text of a case, put where a user finds it.
 */

#include <stdbool.h>

#include "clod/status.h"

/**
 * Write DIR/cases/NAME/case.yaml and make its folders.
 *
 * @param path  [out] of the file
 * Errors  CLOD_FAILED: it cannot be written.   Threads  one per folder.
 */
bool clod_verify_case_file(const char *directory, const char *name, const char *text,
                           char path[4096], clod_status *status);
