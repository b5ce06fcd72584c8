#pragma once
/**
 * @file table.h
 * A CSV file of a results folder, read: columns with their units, cells as texts and as numbers.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/status.h"

typedef struct clod_table {
    char *bytes;  ///< owned: the file, cut into texts
    char **names; ///< [columns] owned list: "shear_stress"
    char **units; ///< [columns] owned list: "Pa"; "" where none is given
    char **cells; ///< [rows][columns] owned list
    size_t rows, columns;
} clod_table;

/**
 * Read a file; a last line without its end, which a run is just writing, is left out.
 *
 * @param self  [out] owned content (clod_table_fini), also after a failure; empty when the file is
 *              not there
 * Errors  CLOD_USAGE: rows of different lengths; CLOD_FAILED: disk, memory.   Threads  safe.
 * Test    tests/report/test_table.c
 */
bool clod_table_read(clod_table *self, const char *folder, const char *name,
                     clod_status *status);

/** The same of a text of so many bytes; `path` is its name in messages. */
bool clod_table_parse(clod_table *self, const char *path, const char *text, size_t length,
                      clod_status *status);

/** Number of the column of this name, or -1. */
int clod_table_find(const clod_table *self, const char *name);

/** Owned numbers [rows] of a column, NaN where the cell is no number; NULL without memory. */
double *clod_table_numbers(const clod_table *self, int column);

/** Free the content; an empty table is fine. */
void clod_table_fini(clod_table *self);
