#pragma once
/**
 * @file source.h
 * Where the keys of a case were written, for errors that are found after it was read.
 *
 * An error of setting up begins with the path of a key, as those of the reader do: "walls.feed.shapes.0: ...".
 */

#include "clod/case.h"
#include "config/load.h"

typedef struct clod_case_source clod_case_source;

/**
 * Keep the tree of a case that was read without an error, with the loader's arena, which is empty afterwards.
 *
 * @param self       case, with path and text
 * @param loader     that has read it
 * @param overrides  number of texts of --set
 * Errors  without memory: in the loader's report.   Test  tests/config/test_source.c
 */
void clod_source_keep(clod_case *self, clod_loader *loader, size_t overrides);

/** Free it and null the pointer; NULL is fine. */
void clod_source_destroy(clod_case_source **self);

/**
 * Put file, line and column of its key before an error of setting up, and the line with a caret behind it;
 * of a key that was not written, those of the section that is. A text that begins with no key of the case
 * stays as it is.
 *
 * @param self    case
 * @param status  [in,out] the error
 * @return        false, always
 * Errors  none.   Threads  pure.   Test  tests/config/test_source.c
 */
bool clod_source_tell(const clod_case *self, clod_status *status);

/** Bytes of where a key stands. */
#define CLOD_SOURCE_WHERE 128

/**
 * Where a key was written, for warnings: "case.yaml:8:3: ", or "" if that is not known, from --set, or too long.
 *
 * @param path   of the key, "walls.feed"
 * @param where  [CLOD_SOURCE_WHERE] [out]
 * @return       where
 * Threads  pure.   Test  tests/config/test_source.c
 */
const char *clod_source_where(const clod_case *self, const char *path, char *where);
