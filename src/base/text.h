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

/** Length of the valid UTF-8 sequence at `text` with `left` bytes; 0: there is none. Threads: pure. */
size_t clod_text_utf8(const char *text, size_t left);

/** Characters of a UTF-8 text. Threads: pure. */
size_t clod_text_characters(const char *text);

/**
 * Copy a UTF-8 text, or of one that has no room its beginning, three points and most of its end, which
 * tells names apart. No character is cut.
 *
 * @param to      [size] [out]; size of at least 16
 * @param size    bytes there are, with the zero at the end
 * @param most    characters that there is room for, at least 8
 * @param from    the text, of which `length` bytes are copied
 * Threads  pure.   Test  tests/base/test_text.c
 */
void clod_text_fit(char *to, size_t size, size_t most, const char *from, size_t length);

/** Names with commas between, of which those that have no room are counted. */
typedef struct clod_text_names {
    char *text;  ///< [size] borrowed; "" before the first
    size_t size; ///< bytes, with the zero at the end
    size_t used, more;
} clod_text_names;

/** An empty list in a text of `size` bytes, more than 32. */
clod_text_names clod_text_names_begin(char *text, size_t size);

/** Add a name; from the first that does not fit on they are counted. */
void clod_text_names_add(clod_text_names *self, const char *name);

/** Say how many have no room: " and 3 more".   Threads  pure.   Test  tests/base/test_text.c */
void clod_text_names_end(clod_text_names *self);

/** Whether two texts differ in numbers alone, if at all.   Threads  pure.   Test  tests/base/test_text.c */
bool clod_text_alike(const char *one, size_t one_length, const char *other,
                     size_t other_length);

/**
 * Put ? in place of each byte of a foreign text that would spoil a terminal or is no text: control
 * characters (of Unicode too, U+0080 to U+009F), and what is not UTF-8.
 *
 * Threads  pure.   Test  tests/base/test_text.c
 */
void clod_text_printable(char *text);
