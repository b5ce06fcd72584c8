#pragma once
/**
 * @file series.h
 * A growing CSV table with units in its header; every row is in the file when the call returns.
 */

#include <stddef.h>
#include <stdint.h>

#include "output/folder.h"

typedef struct clod_series clod_series;

/** How far a table was at a moment, and the checksum of all of it: what a checkpoint stores. */
typedef struct clod_series_mark {
    int64_t bytes;
    uint64_t crc32; ///< clod_file_crc32
} clod_series_mark;

/**
 * Start a table, or go on with one.
 *
 * @param name          of the file in the folder
 * @param columns       [column_count] header texts with units, e.g. "time [s]"
 * @param resume        NULL: a fresh file; else the mark of the checkpoint: what is before it
 * is checked, rows written after it are cut off
 * @return              owned table (clod_series_close), or NULL
 * Errors  CLOD_FAILED: cannot be opened; not what it was at the checkpoint.
 * Threads one per table.   Test  tests/output/test_series.c
 */
clod_series *clod_series_open(const clod_folder *folder, const char *name,
                              const char *const *columns, size_t column_count,
                              const clod_series_mark *resume, clod_status *status);

/** Whether the first mark->bytes of a table are what they were at the checkpoint. */
bool clod_series_check(const clod_folder *folder, const char *name,
                       const clod_series_mark *mark, clod_status *status);

#define CLOD_SERIES_NUMBER 32 // "%.17g" of a double and a comma need at most 25

/** Print a number with as few digits as read back exactly, or nan; returns the length. */
size_t clod_series_number(char text[CLOD_SERIES_NUMBER], double value);

/** Append a row of [column_count] values, printed so that they read back exactly. */
bool clod_series_row(clod_series *self, const double *values, clod_status *status);

/** Append a line of text that the caller has made, with its line end. */
bool clod_series_text(clod_series *self, const char *text, size_t length, clod_status *status);

/** How far the table is: what a checkpoint stores and clod_series_open takes. */
clod_series_mark clod_series_position(const clod_series *self);

/** Bring the rows to the disk; call it before the checkpoint that stores the position. */
bool clod_series_sync(clod_series *self, clod_status *status);

/** Close and null the pointer; NULL is fine. False when what was written may be lost. */
bool clod_series_close(clod_series **self, clod_status *status);
