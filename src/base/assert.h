#pragma once
/**
 * @file assert.h
 * CLOD_ASSERT guards against bugs of our own; users' mistakes are a clod_status instead.
 */

/** Print the broken condition and abort. */
_Noreturn void clod_assert_fail(const char *condition, const char *file, int line);

#define CLOD_ASSERT(condition)                                                                 \
    ((condition) ? (void)0 : clod_assert_fail(#condition, __FILE__, __LINE__))
