#pragma once
/**
 * @file given.h
 * A NULL where a public function needs an argument is answered at its door, with the names of
 * function and argument: by its status, or, without one, by an end of the program.
 */

#include <stdbool.h>

#include "clod/status.h"

/** Stop the program when an argument is missing: for functions without a status. */
void clod_given_need(bool given, const char *function, const char *name);
#define CLOD_NEED(argument) clod_given_need((argument) != NULL, __func__, #argument)

/**
 * Whether an argument is there; else the status says which one is missing.
 *
 * @param given     whether it is
 * @param function  that needs it
 * @param name      of the argument
 * Errors  CLOD_USAGE; a missing status itself stops the program.   Threads  pure.
 * Test    tests/python/test_null.py
 */
bool clod_given(bool given, const char *function, const char *name, clod_status *status);
#define CLOD_GIVEN(argument, status) clod_given((argument) != NULL, __func__, #argument, status)
