#pragma once
/**
 * @file sanitized.h
 * Under the sanitizers a test is ten times slower, and its numbers are those of the normal
 * tree: there it may do fewer steps of the same kind.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>

/** Whether this program looks for races, which one thread alone has not. */
static inline bool looks_for_races(void)
{
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
    return true;
#endif
#endif
    return false;
}

/** Whether the program was built with a sanitizer (ctest says so). */
static inline bool sanitized(void)
{
    return getenv("CLOD_SANITIZED") != NULL;
}

/** Whether the k-th of some sizes is left out: with sanitizers one is enough, which is large enough for all
 *  that happens. */
static inline bool left_out(size_t k, size_t enough)
{
    return sanitized() && k != enough;
}
