#pragma once
/**
 * @file warnings.h
 * What is said beside a design.
 */

#include <stddef.h>

#define CLOD_HOPPER_WARNINGS 64
#define CLOD_HOPPER_WARNING_TEXT 320

typedef struct clod_hopper_warnings {
    size_t count;
    char text[CLOD_HOPPER_WARNINGS][CLOD_HOPPER_WARNING_TEXT];
} clod_hopper_warnings;

/** Add one; when there is no room the last says that there are more. */
void clod_hopper_warn(clod_hopper_warnings *self, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
