#pragma once
/**
 * @file csv.h
 * Tables of measured values from CSV files: `,` `;` or tab, units in the header, `#` for comments. Empty cells
 * behind the last column are none, and columns such as point or remark are not read.
 * What the columns mean says the caller; errors name file, line and column.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/status.h"

#define CLOD_CSV_COLUMNS 64 ///< of a file, at most
#define CLOD_CSV_KINDS 24   ///< of columns that a table knows, at most

/** What a column means. */
typedef struct clod_csv_column {
    const char *names[3]; ///< the first is the name in messages
    const char *unit;     ///< SI; "" for a whole number
    bool positive;        ///< 0 is not allowed
    bool required;
    double below; ///< values are smaller than this, SI; 0: anything goes
    double
        least;   ///< values are no smaller than this, SI; below 0 it allows them to be negative
    double most; ///< and no larger than this, SI; 0: anything goes
    size_t offset; ///< in a row: of a double, of an int64_t for a whole number
} clod_csv_column;

typedef struct clod_csv clod_csv;

/** What a table is. */
typedef struct clod_csv_kind {
    const clod_csv_column *columns; ///< [count]
    size_t count;                   ///< at most CLOD_CSV_KINDS
    size_t row;                     ///< bytes of a row
    const char *known;              ///< names of the columns, for messages
    const char *example;            ///< a header
    const char *item;               ///< what a row is: "shear point"
    const size_t *line; ///< where in a row the number of its line goes, a size_t; NULL: nowhere
    const char *const *skipped; ///< more columns that are not read, ended by NULL; NULL: none
    bool (*check_header)(const clod_csv *self); ///< NULL: nothing more to check
    bool (*check_row)(const clod_csv *self, const void *row);
} clod_csv_kind;

/** A file that is being read, and what has been read. */
struct clod_csv {
    const clod_csv_kind *kind;
    const void *first; ///< content of a row before its cells are read; NULL: zeros
    const char *path;  ///< as messages name it
    clod_status *status;
    void *rows; ///< [count] owned (clod_memory_free)
    size_t count, capacity;
    bool gap[CLOD_CSV_KINDS]; ///< whether a cell of this column is empty in some row
    size_t line;              ///< number of the line at hand
    char separator;
    size_t width;                                    ///< columns in the header
    const clod_csv_column *column[CLOD_CSV_COLUMNS]; ///< of each; NULL: skipped
    const char *unit[CLOD_CSV_COLUMNS];              ///< as written in the header
};

/**
 * Read a table.
 *
 * @param self    kind, path and status are set, the rest is zero or as described
 * @param text    [length]
 * @return        false: nothing is owned
 * Errors  CLOD_USAGE with file:line, column, value and what to do; CLOD_FAILED: memory.
 * Threads safe.   Test  tests/analysis/test_points.c, tests/hopper/test_refusals.py
 */
bool clod_csv_parse(clod_csv *self, const char *text, size_t length);

/** Whether the header has a column of the kind. */
bool clod_csv_has(const clod_csv *self, size_t column);

/** Record what is wrong with a cell, with its place and value; false. */
bool clod_csv_fail(const clod_csv *self, const clod_csv_column *column, const char *cell,
                   const char *fault);

/** What ends a sentence behind a text that may be a question already. */
const char *clod_csv_stop(const char *text);
