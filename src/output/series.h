#pragma once
/**
 * @file series.h
 * A growing CSV table with units in its header; every row is in the file when the call returns.
 */

#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"

typedef struct clod_series clod_series;

/**
 * Start a table, or go on with one.
 *
 * @param path          the CSV file
 * @param columns       [column_count] header texts with units, e.g. "time [s]"
 * @param resume_bytes  < 0: a fresh file; else what clod_series_bytes said at the checkpoint:
 *                      rows written after it are cut off
 * @return              owned table (clod_series_close), or NULL
 * Errors  CLOD_FAILED: cannot be opened; shorter or with other columns than at the checkpoint.
 * Threads one per table.   Test  tests/output/test_series.c
 */
clod_series *clod_series_open(const char *path, const char *const *columns, size_t column_count,
                              int64_t resume_bytes, clod_status *status);

/** Append a row of [column_count] values, printed so that they read back exactly. */
bool clod_series_row(clod_series *self, const double *values, clod_status *status);

/** Length of the file so far [bytes]: what a checkpoint stores and resume_bytes takes. */
int64_t clod_series_bytes(const clod_series *self);

/** Bring the rows to the disk; call it before the checkpoint that stores clod_series_bytes. */
bool clod_series_sync(clod_series *self, clod_status *status);

/** Close and null the pointer; NULL is fine. */
void clod_series_close(clod_series **self);
