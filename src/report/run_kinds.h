#pragma once
/**
 * @file run_kinds.h
 * What differs between kinds of case on the pages of their runs: one row each.
 */

#include <jansson.h>
#include <stdio.h>

#include "analysis/measured_header.h"
#include "report/run_files.h"
#include "report/sheet.h"
#include "report/writer.h"

struct clod_run_kind {
    const char *text; ///< for people
    bool checked;     ///< its runs have checks that could warn

    /** The few numbers that matter most. */
    void (*cards)(FILE *out, const clod_run_files *run);

    /** What the page of a run shows, with the laboratory's results laid over (NULL: none).
     *  Errors  CLOD_USAGE: a damaged table. */
    bool (*put)(clod_sheet *sheet, const clod_run_files *run, const json_t *lab,
                clod_status *status);

    /** Results of a laboratory's table, owned, or NULL with status; NULL: it takes none. */
    json_t *(*lab)(const char *path, clod_status *status);
    clod_measured_stress stress; ///< of such a table

    /** The tables of a comparison. Errors  CLOD_FAILED: no memory. */
    bool (*results)(clod_writer out, const clod_run_files *runs, size_t count,
                    const json_t *lab, clod_status *status);

    /** The figures of a comparison. Errors  as put; CLOD_FAILED: no memory. */
    bool (*figures)(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                    const json_t *lab, clod_status *status);
};

/** Row of the kind of a complete case; borrowed. Threads  pure.   Test  tests/report/test_run_kinds.c */
const clod_run_kind *clod_run_kinds_of(const char *complete);

/**
 * Results of a laboratory for the page of a run.
 *
 * @return  owned, or NULL
 * Errors  CLOD_USAGE: the table; the page of such a run takes none. CLOD_FAILED: no memory.
 */
json_t *clod_run_kinds_lab(const char *path, const clod_run_files *run, clod_status *status);
