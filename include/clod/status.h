#pragma once
/**
 * @file status.h
 * Outcome of every call that can fail: a code and a text that tells the user what to do.
 *
 * A NULL where an argument is needed is answered at once, by every function of include/clod:
 * with CLOD_USAGE and the names of function and argument. Functions without a status stop the
 * program instead, naming both; so does a status that is NULL. Where NULL is fine the comment of
 * the function says so.   Test  tests/python/test_null.py
 */

#include <stdarg.h>
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CLOD_STATUS_TEXT 16384

/** Exit status of the program that goes with an outcome. */
typedef enum clod_code {
    CLOD_OK = 0,
    CLOD_FAILED = 1,      ///< the run went wrong: disk, memory, physics
    CLOD_USAGE = 2,       ///< the case file, an input file or the command line is wrong
    CLOD_INTERRUPTED = 3, ///< a signal asked the run to stop; everything is on disk
} clod_code;

/** Outcome of a call; `text` is complete sentences for the user, several lines if need be. */
typedef struct clod_status {
    clod_code code;
    char text[CLOD_STATUS_TEXT];
} clod_status;

/**
 * Record a failure and return false, so that callers write `return clod_status_fail(...)`.
 *
 * @param status  [out] the outcome
 * @param code    what kind of failure
 * @param format  printf format of the text: what, where, value, allowed range, what to do
 * @return        false, always
 * Errors  none; NULL for status or format stops the program.   Threads  pure.
 * Test    tests/base/test_status.c
 */
bool clod_status_fail(clod_status *status, clod_code code, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** The same with a va_list. */
bool clod_status_vfail(clod_status *status, clod_code code, const char *format, va_list args);

#ifdef __cplusplus
}
#endif
