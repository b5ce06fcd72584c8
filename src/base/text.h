#pragma once
/**
 * @file text.h
 * A text written piece by piece with fprintf, whole or not at all: open_memstream of glibc 2.36
 * drops what it has no memory for, and neither ferror nor fclose tells.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

typedef struct clod_text {
    FILE *out;   ///< written to by the owner
    char *bytes; ///< owned, ends with 0
    size_t length, capacity;
    bool lost; ///< there was no memory for something
} clod_text;

/** Begin a text, which must stay where it is until it is closed; its stream, NULL without
 * memory. */
FILE *clod_text_open(clod_text *self);

/**
 * End a text that was opened.
 *
 * @return  owned text (clod_memory_free), or NULL when there was no memory for all of it
 * Threads  one per text.   Test  tests/base/test_text.c
 */
char *clod_text_close(clod_text *self);
