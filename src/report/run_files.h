#pragma once
/**
 * @file run_files.h
 * A results folder opened for its page: summary, texts, parts.
 */

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "clod/status.h"

typedef struct clod_run_kind clod_run_kind; // run_kinds.h

typedef struct clod_run_files {
    char *folder;        ///< owned
    const char *name;    ///< end of `folder`: what the run is called beside others
    char *title;         ///< owned: of the case, or the folder
    char *case_text;     ///< owned: case.yaml; NULL: none
    char *complete;      ///< owned: case-complete.yaml; NULL: none
    char *report;        ///< owned: report.txt; NULL while the run is not complete
    json_t *summary;     ///< owned; NULL while there is none
    json_t *log;         ///< owned: `version` and `parts` as log.jsonl tells them, for as long
    json_t *damage;      ///< owned: list of texts, what its files lack (run_damage.h)
    char *began, *ended; ///< owned: when, UTC; NULL: the log does not say
    const clod_run_kind *kind;
} clod_run_files;

/**
 * Open a folder.
 *
 * @param self  [out] owned content (clod_run_files_fini), also after a failure
 * Errors  CLOD_USAGE: no results folder, a damaged summary; CLOD_FAILED: disk, memory.
 * Threads safe.   Test  tests/report/test_page.py
 */
bool clod_run_files_open(clod_run_files *self, const char *folder, clod_status *status);

/**
 * Name runs that stand side by side: the last name of each folder, and as many of those above it as
 * it takes for all names to differ.
 *
 * @param runs  [count] opened, of other folders   Test  tests/report/test_compare.py
 */
void clod_run_files_names(clod_run_files *runs, size_t count);

/** Number k of the parts that the run has, borrowed; NULL behind the last. */
const char *clod_run_files_part(const clod_run_files *self, size_t k);

/** What computed it, borrowed; NULL: not known. */
const char *clod_run_files_version(const clod_run_files *self);

/** Gravity of the complete case [m/s2]; 0 where it says none.   Test  tests/python/test_slices.py */
void clod_run_files_gravity(const clod_run_files *self, double gravity[3]);

/** Free the content; an empty one is fine. */
void clod_run_files_fini(clod_run_files *self);
