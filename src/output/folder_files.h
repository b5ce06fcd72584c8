#pragma once
/**
 * @file folder_files.h
 * Files of an open folder, by their names in it: read, replaced at one stroke, removed.
 *
 * Only ENOENT means that a file is not there; every other error stops with its text.
 */

#include <jansson.h>
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

/**
 * Replace a file: write `name`.part, bring it to the disk, see that the path of the folder
 * still is this folder, rename it to `name`, bring that to the disk.
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

/** Replace a file by a text. */
bool clod_folder_write(const clod_folder *self, const char *name, const char *text,
                       clod_status *status);

/** Replace a file by indented JSON; `json` is borrowed. */
bool clod_folder_write_json(const clod_folder *self, const char *name, const json_t *json,
                            clod_status *status);

/** Write the copies of the case: case.yaml as given, case-complete.yaml with all defaults. */
bool clod_folder_write_case(const clod_folder *self, const char *case_text,
                            const char *complete_text, clod_status *status);
