#pragma once
/**
 * @file text_file.h
 * Results as text files: replaced at one stroke, and never over what they were made from.
 */

#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Replace a file by a text: a reader sees the old content or the new, never half.
 *
 * @param path    file to create or replace; what is there and no regular file (a pipe, a
 *                terminal) is written to
 * @param input   file that the text was made from, never written over
 * @param text    whole content
 * @param status  [out] on failure a regular file at `path` is untouched
 * Errors  CLOD_USAGE: a NULL (clod/status.h), path and input are the same file; CLOD_FAILED: no folder, no right, disk
 *         full.   Threads  one per path.
 * Test    tests/output/test_text_file.c
 */
bool clod_text_file_write(const char *path, const char *input, const char *text,
                          clod_status *status);

#ifdef __cplusplus
}
#endif
