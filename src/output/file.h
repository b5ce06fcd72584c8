#pragma once
/**
 * @file file.h
 * Whole files read and replaced in one go: a reader sees the old content or the new, never
 * half. Calls that a signal cuts short are made again.
 */

#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"

/** Write all bytes to an open file, going on after signals; false with errno set. */
bool clod_file_write_all(int descriptor, const void *bytes, size_t size);

/** Write all bytes from byte `at` of an open file on; 0 or an errno value. */
int clod_file_write_at(int descriptor, uint64_t at, const void *bytes, size_t size);

/** Read all bytes from byte `at` of an open file on; 0 or an errno value, EIO at its end. */
int clod_file_read_at(int descriptor, uint64_t at, void *bytes, size_t size);

/** Make an open file so long; 0 or an errno value. */
int clod_file_truncate(int descriptor, uint64_t size);

/** openat with mode 0666 and O_CLOEXEC, again after signals; -1 with errno set. */
int clod_file_open(int folder, const char *name, int flags);

/** Bring an open file or folder to the disk, again after signals; 0 or an errno value. */
int clod_file_sync(int descriptor);

/** Bring the entry of a new file or folder in the folder above it to the disk; 0 or errno. */
int clod_file_sync_entry(const char *path);

/** Close; 0 or an errno value. The descriptor is free in any case, after a signal too. */
int clod_file_close(int descriptor);

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

/**
 * Read a whole file into owned memory (clod_memory_free), a zero byte behind its end.
 *
 * @param folder  descriptor that `name` is relative to, or AT_FDCWD
 * @return        0 or an errno value; *bytes is NULL then
 */
int clod_file_load(int folder, const char *name, void **bytes, size_t *size);

/** The same, with a text when it does not succeed. */
bool clod_file_read(const char *path, void **bytes, size_t *size, clod_status *status);

/** Whether something is there; false with status when that cannot be told. */
bool clod_file_is_there(const char *path, bool *there, clod_status *status);

/** Whether an errno value says that there is no room: a full disk, a quota, a size limit. */
bool clod_file_is_full(int error);

/**
 * Record that `action` ("write", "open") on `path` failed with errno value `error`.
 * For a file of a run's folder: clod_folder_fail.
 */
bool clod_file_fail(clod_status *status, const char *action, const char *path, int error);

/** Continue a CRC-32 (of zlib, gzip and Python's zlib.crc32) over some bytes; 0 begins one. */
uint64_t clod_file_crc32(uint64_t sum, const void *bytes, size_t size);

/** Start of a chain of clod_file_hash. */
#define CLOD_FILE_HASH_START 0x9e3779b97f4a7c15u

/**
 * Continue a 64-bit hash over some bytes. A change of one byte changes
 * the result for certain, any other change but for one chance in 2^64.
 */
uint64_t clod_file_hash(uint64_t hash, const void *bytes, size_t size);

/**
 * The same of bytes that come in pieces, each but the last a multiple of 8 long: words of each
 * piece, then the end with the size of all of them.
 */
uint64_t clod_file_hash_words(uint64_t hash, const void *bytes, size_t size);
uint64_t clod_file_hash_end(uint64_t hash, uint64_t size);

/** Bytes of a block: blocks of a file are hashed by anybody, in any order. */
#define CLOD_FILE_BLOCK ((uint64_t)1 << 20)

/** Blocks of so many bytes; the last may be shorter. */
uint64_t clod_file_blocks(uint64_t bytes);

/** Hash of block `number` of the `bytes` from byte `start` of an open file on; 0 or an errno value. */
int clod_file_hash_block(int descriptor, uint64_t start, uint64_t bytes, uint64_t number,
                         uint64_t *hash);
