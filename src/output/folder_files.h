#pragma once
/**
 * @file folder_files.h
 * Files of an open folder, by their names in it: read, replaced at one stroke, removed.
 *
 * Only ENOENT means that a file is not there; every other error stops with its text.
 */

#include <jansson.h>
#include <limits.h>
#include <stddef.h>

#include "output/folder.h"

/** Record that `action` on the file `name` of the folder failed with errno value `error`. */
bool clod_folder_fail(const clod_folder *self, const char *action, const char *name, int error,
                      clod_status *status);

/** Whether there is something of this name. */
bool clod_folder_has(const clod_folder *self, const char *name, bool *there,
                     clod_status *status);

/**
 * Open a file to write rows or lines to it; symbolic links are not followed.
 * @param flags  of open(2)
 * @return       descriptor, or -1 with status
 */
int clod_folder_open_file(const clod_folder *self, const char *name, int flags,
                          clod_status *status);

/**
 * Read a whole file, a zero byte behind its end.
 * @param bytes  [out] owned (clod_memory_free); NULL when there is no such file
 */
bool clod_folder_read(const clod_folder *self, const char *name, void **bytes, size_t *size,
                      clod_status *status);

/** A file that is being written, to take the place of another at one stroke. */
typedef struct clod_folder_draft {
    const clod_folder *folder; ///< borrowed
    const char *name;          ///< borrowed: of the file that it will be
    char part[NAME_MAX + 1];   ///< until then
    int descriptor;            ///< to write to, and to read from
} clod_folder_draft;

/**
 * Begin to replace a file: open `name`.part, empty.
 *
 * @param self    [out] clod_folder_draft_end must be called after a success
 * @param status  [out] on failure there is nothing to end
 * Errors  CLOD_FAILED: no folder, no right, a link in the way.   Threads  one per file.
 */
bool clod_folder_draft_begin(clod_folder_draft *self, const clod_folder *folder,
                             const char *name, clod_status *status);

/**
 * Bring the draft to the disk, see that the path of the folder still is this folder, rename the
 * draft to its name, bring that to the disk.
 *
 * @param good    whether all was written; if not, `status` says why, and the draft is removed
 * @param status  [out] on failure no .part is left, and the file is the old one or the new
 * @return        whether the file is replaced
 * Errors  CLOD_FAILED: disk full, folder moved away or replaced.
 * Test    tests/output/test_folder.c, test_checkpoint.c
 */
bool clod_folder_draft_end(clod_folder_draft *self, bool good, clod_status *status);

/**
 * Replace a file by these bytes, as a draft.
 *
 * @param head    first bytes, may be NULL when head_size is 0
 * @param body    the bytes that follow, may be NULL when body_size is 0
 * @param status  [out] on failure no .part is left, and the file is the old one or the new
 * Errors  CLOD_FAILED: disk full, folder moved away or replaced.   Threads  one per file.
 * Test    tests/output/test_folder.c
 */
bool clod_folder_replace(const clod_folder *self, const char *name, const void *head,
                         size_t head_size, const void *body, size_t body_size,
                         clod_status *status);

/** Remove a file; none of this name is fine. */
bool clod_folder_remove(const clod_folder *self, const char *name, clod_status *status);

/** Replace a file by a text; NULL: there was no memory for it, which is a failure. */
bool clod_folder_write(const clod_folder *self, const char *name, const char *text,
                       clod_status *status);

/** Replace a file by indented JSON; `json` is borrowed. NULL, of json_pack, is a
 *  failure: no memory, or a number that is not finite. */
bool clod_folder_write_json(const clod_folder *self, const char *name, const json_t *json,
                            clod_status *status);

/** Write the copies of the case: case.yaml as given, case-complete.yaml with all defaults. */
bool clod_folder_write_case(const clod_folder *self, const char *case_text,
                            const char *complete_text, clod_status *status);
