#pragma once
/**
 * @file file.h
 * Whole files read and replaced in one go: a reader sees the old content or the new, never
 * half.
 */

#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"

/** Join directory and name as "directory/name"; false when it does not fit. */
bool clod_file_path(char *path, size_t size, const char *directory, const char *name,
                    clod_status *status);

/** Write all bytes to an open file, going on after signals; false with errno set. */
bool clod_file_write_all(int descriptor, const void *bytes, size_t size);

/**
 * Replace a file: write `path`.part, bring it to the disk, rename it to `path`.
 *
 * @param path    file to create or replace
 * @param head    first bytes, may be NULL when head_size is 0
 * @param body    the bytes that follow, may be NULL when body_size is 0
 * @param status  [out] on failure the old file is untouched and no .part is left
 * Errors  CLOD_FAILED: no folder, no right, disk full.   Threads  one per path.
 * Test    tests/output/test_file.c
 */
bool clod_file_replace(const char *path, const void *head, size_t head_size, const void *body,
                       size_t body_size, clod_status *status);

/** Read a whole file into owned memory (clod_memory_free), a zero byte behind its end. */
bool clod_file_read(const char *path, void **bytes, size_t *size, clod_status *status);

/** Record that `action` ("write", "open") on `path` failed with errno value `error`. */
bool clod_file_fail(clod_status *status, const char *action, const char *path, int error);

/** Start of a chain of clod_file_hash. */
#define CLOD_FILE_HASH_START 0x9e3779b97f4a7c15u

/**
 * Continue a 64-bit hash over some bytes. A change of one byte changes
 * the result for certain, any other change but for one chance in 2^64.
 */
uint64_t clod_file_hash(uint64_t hash, const void *bytes, size_t size);
