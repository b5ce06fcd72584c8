#pragma once
/**
 * @file run_damage.h
 * Files of a complete run that have less in them than its summary says.
 */

#include "report/report.h"
#include "report/run_files.h"

/**
 * List what is missing in `damage` of a complete run: tables of parts that end before the part did or are not there, and
 * a table of results that is there and has fewer rows than the summary has points. Of a run that goes on nothing is listed.
 *
 * @param self  opened but for this
 * Errors  CLOD_FAILED: disk, memory.   Threads  safe.   Test  tests/report/test_damage.py
 */
bool clod_run_damage_look(clod_run_files *self, clod_status *status);

/** Add a text to the list, as printf. Errors  CLOD_FAILED: no memory. */
bool clod_run_damage_add(clod_run_files *self, clod_status *status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Tell the texts of the list, one by one, whom the page is made for. */
void clod_run_damage_tell(const clod_run_files *self, const clod_report_options *options);
