#pragma once
/**
 * @file case_of.h
 * Cases of texts and files, owned by the caller. One that is wrong fails the test with what it is told.
 */

#include <string.h>

#include "clod/case.h"
#include "support/check.h"

/** The case of a text that stands at a path, with `count` changes. */
static inline clod_case *case_at(const char *path, const char *text, const char *const *changes,
                                 size_t count)
{
    clod_status told = {CLOD_OK, ""};
    clod_case *from = clod_case_parse(path, text, strlen(text), changes, count, &told);
    if (from == NULL) {
        fail_msg("%s", told.text);
    }
    return from;
}

/** The case of a text, with one change or NULL. */
static inline clod_case *case_of(const char *text, const char *change)
{
    return case_at("case.yaml", text, &change, change != NULL);
}

/** The case of a file, with `count` changes. */
static inline clod_case *case_in(const char *path, const char *const *changes, size_t count)
{
    clod_status told = {CLOD_OK, ""};
    clod_case *from = clod_case_load(path, changes, count, &told);
    if (from == NULL) {
        fail_msg("%s", told.text);
    }
    return from;
}
