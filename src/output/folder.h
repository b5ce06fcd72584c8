#pragma once
/**
 * @file folder.h
 * The results folder: made, locked against a second run, kept open. All files in it are named
 * relative to the open folder, so a run never writes into another folder that takes its path.
 */

#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"

/** A folder that is open. */
typedef struct clod_folder {
    char *path;     ///< owned; as it was given, for messages
    int descriptor; ///< of the folder; names are relative to it
    int lock;       ///< descriptor of the lock file; -1 when the folder is only read
} clod_folder;

/**
 * Name of the folder for a case when none is given: "run/NAME" for ".../NAME.yaml", and for
 * ".../NAME/case.yaml", since many cases are called that.
 *
 * @return  owned text (clod_memory_free), or NULL
 * Errors  CLOD_FAILED: no memory; the folder of the case cannot be looked at.
 */
char *clod_folder_default(const char *case_path, clod_status *status);

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

/** Open a folder that is there, to read from it only; it is not locked. */
clod_folder *clod_folder_look(const char *path, clod_status *status);

/**
 * Whether the path still leads to this folder, and the lock file in it is still the locked one.
 * Errors  CLOD_FAILED: moved away, removed or replaced.   Test  tests/output/test_folder.c
 */
bool clod_folder_check(const clod_folder *self, clod_status *status);

/** What tells a folder from another one of the same name, on whatever host: its lock file. Plain data, all of
 *  its bytes are set. */
typedef struct clod_folder_mark {
    uint64_t file;                ///< number of the lock file in its file system
    int64_t seconds, nanoseconds; ///< when it was locked last
} clod_folder_mark;

/** The mark of a folder that some run has locked.
 *  Errors  CLOD_FAILED: it has no lock file.   Test  tests/output/test_folder.c */
bool clod_folder_mark_of(const clod_folder *self, clod_folder_mark *mark, clod_status *status);

bool clod_folder_mark_equals(const clod_folder_mark *a, const clod_folder_mark *b);

/** Unlock, free and null the pointer; NULL is fine. */
void clod_folder_close(clod_folder **self);

/** Free disk space for this user where the folder is or would be made [bytes]. */
bool clod_folder_space(const char *path, double *bytes, clod_status *status);
