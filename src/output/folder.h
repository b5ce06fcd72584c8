#pragma once
/**
 * @file folder.h
 * The results folder: made, locked against a second run, cleared of what clod wrote.
 */

#include <jansson.h>
#include <stddef.h>

#include "clod/status.h"

typedef struct clod_folder clod_folder;

/**
 * Owned text "run/NAME" for a case file ".../NAME.yaml", and for ".../NAME/case.yaml", since
 * many cases are called that; NULL without memory.
 */
char *clod_folder_default(const char *case_path);

/** Make a folder and its parents; one that exists is fine. */
bool clod_folder_make(const char *path, clod_status *status);

/**
 * Make the folder if need be and lock it for this run. The lock file stays and marks the folder
 * as one of clod's: files in it that have the names of results are results. A folder without it
 * that has such a file, or a case.yaml, belongs to someone else and is not touched.
 *
 * @return  owned folder (clod_folder_close), or NULL
 * Errors  CLOD_USAGE: another run is writing into it, files of someone else are in the way, or
 *         the path is that of a file.  CLOD_FAILED: cannot be made.
 * Threads safe.   Test  tests/output/test_folder.c, tests/cli/test_folder.py
 */
clod_folder *clod_folder_open(const char *path, clod_status *status);

/** The path it was opened with, borrowed. */
const char *clod_folder_path(const clod_folder *self);

/** Unlock, free and null the pointer; NULL is fine. */
void clod_folder_close(clod_folder **self);

/**
 * Remove the files with the names that a run gives (--fresh), and nothing else; no sub-folders.
 * The copies of the case stay (the run that follows replaces them): one of them may be the very
 * file that the run was started with.
 *
 * Errors  CLOD_FAILED: the folder cannot be read, a file cannot be removed.
 * Threads one per folder.   Test  tests/output/test_folder.c, tests/cli/test_folder.py
 */
bool clod_folder_clear(const clod_folder *self, clod_status *status);

/** Write the copies of the case: case.yaml as given, case-complete.yaml with all defaults. */
bool clod_folder_write_case(const char *directory, const char *case_text,
                            const char *complete_text, clod_status *status);

/** Replace a file by a text, at one stroke. */
bool clod_folder_write(const char *path, const char *text, clod_status *status);

/** Replace a file by indented JSON, at one stroke; `json` is borrowed. */
bool clod_folder_write_json(const char *path, const json_t *json, clod_status *status);

/** Free disk space for this user where the folder is or would be made [bytes]. */
bool clod_folder_space(const char *path, double *bytes, clod_status *status);
