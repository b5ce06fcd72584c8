#pragma once
/**
 * @file input.h
 * Files that the user names, read whole, and messages that say what is wrong with them.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/status.h"

/** What messages call standard input. */
#define CLOD_INPUT_STANDARD "standard input"

/** Byte order mark that spreadsheets and some editors put before a text in UTF-8. */
#define CLOD_INPUT_MARK "\xEF\xBB\xBF"

/**
 * Read a file, a pipe, or standard input to its end.
 *
 * @param path    the file; NULL for standard input
 * @param most    bytes to read at most; what is behind them is left
 * @param text    [out] owned (clod_memory_free), a zero byte behind its end
 * @param length  [out] without that zero byte
 * Errors  CLOD_USAGE: not there, a folder, no right to read it; CLOD_FAILED: the disk, memory.
 * Threads safe.   Test  tests/base/test_input.c
 */
bool clod_input_read(const char *path, size_t most, char **text, size_t *length,
                     clod_status *status);

/**
 * Read what a user names: a file, or "-" for standard input.
 *
 * @param path  "-", or a path; [out] what messages call it
 */
bool clod_input_read_named(const char **path, char **text, size_t *length, clod_status *status);

/**
 * Read a regular file. Anything else that can be opened (a pipe, a device) may never end and is
 * refused, as is a file that is too large; both before memory is taken.
 *
 * @param path    the file
 * @param most    bytes of the largest file that is read
 * @param text    [out] owned (clod_memory_free), a zero byte behind its end
 * @param length  [out] without that zero byte
 * Errors  CLOD_USAGE: as clod_input_read, no regular file, too large; CLOD_FAILED: the disk,
 *         memory.   Threads  safe.   Test  tests/base/test_input.c
 */
bool clod_input_read_regular(const char *path, size_t most, char **text, size_t *length,
                             clod_status *status);

/** Bytes of the byte order mark at the start of a text, 0 without one. */
size_t clod_input_mark(const char *text);
