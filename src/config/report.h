#pragma once
/**
 * @file report.h
 * Errors of a case file: collected, put in the order of lines, shown with source line and
 * caret.
 */

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>

#include "clod/status.h"
#include "config/tree.h"

typedef struct clod_report_item {
    clod_place place;
    size_t order;        ///< in which it was found
    const char *path;    ///< "grains.0.count"; "" for the file as a whole
    const char *message; ///< without line end
} clod_report_item;

typedef struct clod_report {
    const char *name; ///< of the file, as the user wrote it
    const char *text; ///< of the file
    size_t length;
    const char *included_name, *included_text; ///< of the file that it includes; NULL: none
    size_t included_length;
    const char *const *overrides; ///< texts of --set
    clod_arena arena;
    clod_report_item *items; ///< owned
    size_t count, capacity;
    clod_index known; ///< "source:line:column:message" of the errors
    clod_index paths; ///< those at or below which there is an error
    bool lost;        ///< memory ran out while an error was recorded
} clod_report;

/** Record an error at a place; the same error at the same place is kept once. */
void clod_report_add(clod_report *self, clod_place place, const char *path, const char *format,
                     ...) __attribute__((format(printf, 4, 5)));

/** True when no error was found at `path` or below it. */
bool clod_report_clean(const clod_report *self, const char *path);

/** Write one error into the status, whatever was recorded; false, always. `path` may be "". */
bool clod_report_one(const clod_report *self, clod_place place, const char *path,
                     const char *message, clod_code code, clod_status *status);

/** Write all errors into the status; false when there are any. */
bool clod_report_finish(clod_report *self, clod_status *status);

void clod_report_fini(clod_report *self);
