#pragma once
/**
 * @file report.h
 * A results folder as one page that a browser shows without a network: `clod report`, and many
 * of them on one page: `clod compare`. Figures are in the page and beside it as SVG.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/hopper.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What a page is made of, and where it goes. */
typedef struct clod_report_options {
    const char *const *runs; ///< [run_count] results folders
    size_t run_count;
    const char *lab;    ///< CSV file of measured shear points to lay over; NULL: none
    const char *output; ///< HTML file; NULL: report.html in the folder, or compare.html
    /** Told what files of the runs lack, which the page says among its warnings; NULL: nobody. */
    void (*tell)(const char *text);
    /** Told the warnings and results of a comparison as text, when its page is written; NULL: nobody. */
    void (*show)(const char *text);
} clod_report_options;

/**
 * Write the page of one run, or of a calibration: warnings, results, curves, tables, a view of its last snapshot, case
 * and provenance; and each figure as SVG beside it. The run may still be going on. A snapshot that is missing or damaged
 * is left out, and said.
 *
 * @param options  with one run
 * @param path     [out] owned name of the page (clod_report_free)
 * Errors  CLOD_USAGE: no results folder, a damaged file, laboratory points that are none or do
 *         not belong to such a run, a file in the way of a figure; CLOD_FAILED: disk, memory.
 * Threads one at a time.
 * Test    tests/report/
 */
bool clod_report_write(const clod_report_options *options, char **path, clod_status *status);

/**
 * Write one page of several runs: one table of their results and of the keys in which their cases
 * differ, curves over each other. Otherwise as clod_report_write.
 */
bool clod_report_compare(const clod_report_options *options, char **path, clod_status *status);

/**
 * Write the page of a design: warnings, what to build, figures, numbers, provenance; and each figure
 * as SVG beside it.
 *
 * @param path     of the page: NAME.html
 * @param figures  [out] number of SVG files, NAME-FIGURE.svg
 * Errors  CLOD_USAGE: a file in the way of a figure; CLOD_FAILED: disk, memory.   Threads  one at a time.
 * Test    tests/report/test_hopper_page.py
 */
bool clod_report_hopper(const clod_hopper *design, const char *path, size_t *figures,
                        clod_status *status);

/** NULL, or what the pages lack because clod was built without their scripts, and how to get it.
 */
const char *clod_report_lacks(void);

/** Owned name of the results folder that `clod run` takes for a case when none is given; NULL with
 *  status as clod_run fails then. */
char *clod_report_folder(const char *case_path, clod_status *status);

/** Free a text; NULL is fine. */
void clod_report_free(char *text);

#ifdef __cplusplus
}
#endif
