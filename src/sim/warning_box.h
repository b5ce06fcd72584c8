#pragma once
/**
 * @file warning_box.h
 * Warnings of a simulation: texts in a list, and the box under the results that shows them.
 */

#include <jansson.h>
#include <stdio.h>

/** Add a warning, at most some 600 characters. */
void clod_warning_box_add(json_t *list, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** Write the box into a file, its lines broken; nothing when there is nothing to warn of. */
void clod_warning_box_put(FILE *out, const json_t *list);

/** Characters that the box takes. */
size_t clod_warning_box_size(const json_t *list);

/** Append the box to a text with room for it; nothing when there is nothing to warn of. */
void clod_warning_box_append(char *text, size_t size, const json_t *list);
