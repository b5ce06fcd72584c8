#pragma once
/**
 * @file json.h
 * JSON texts made with jansson, whole or not at all: json_object_set_new and the like leave out
 * what there is no memory for, and a text made of the rest would look complete.
 */

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "clod/status.h"

/**
 * The text of a value.
 *
 * @param flags  of json_dumps
 * @return       owned text (clod_memory_free); NULL when jansson found no memory for a value or
 *               text in this thread since the last call, or for this text
 * Threads  safe.   Test  tests/faults/test_alloc_faults.py
 */
char *clod_json_text(const json_t *value, size_t flags);

/** A new real number; null for one that is not finite. Threads: safe. */
json_t *clod_json_number(double value);

/** Whether jansson found no memory for something in this thread since the last text. */
bool clod_json_lacks_memory(void);

/**
 * The value of a text [length]. Without memory jansson may leave out characters and take the rest for whole.
 *
 * @param error  [out] where it is damaged; NULL: nobody asks
 * @return       owned (json_decref); NULL: damaged, or there was no memory, which clod_json_lacks_memory tells
 * Threads  safe.   Test  tests/faults/test_alloc_faults.py
 */
json_t *clod_json_parse(const char *text, size_t length, json_error_t *error);

/**
 * Read a file of a folder that clod wrote.
 *
 * @return  owned (json_decref), NULL with status
 * Errors  CLOD_USAGE with file and line: damaged, or as clod_input_read_regular; CLOD_FAILED: disk, memory.
 * Threads  safe.   Test  tests/base/test_json.c
 */
json_t *clod_json_read(const char *folder, const char *name, clod_status *status);
