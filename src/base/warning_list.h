#pragma once
/**
 * @file warning_list.h
 * What is said beside a result.
 */

#include <stddef.h>

#define CLOD_WARNING_LIST_MOST 64
#define CLOD_WARNING_LIST_TEXT 512

typedef struct clod_warning_list {
    size_t count;
    char text[CLOD_WARNING_LIST_MOST][CLOD_WARNING_LIST_TEXT];
} clod_warning_list;

/** Add one; when there is no room the last says that there are more.
 *  Test  tests/base/test_warning_list.c */
void clod_warning_list_add(clod_warning_list *self, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
