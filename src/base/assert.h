#pragma once
/**
 * @file assert.h
 * CLOD_ASSERT guards against bugs of our own; users' mistakes are a clod_status instead. Without a
 * status to fill, a NULL of a caller ends the program too, with a text that names it.
 */

/** Print the broken condition and abort. */
_Noreturn void clod_assert_fail(const char *condition, const char *file, int line);

/** Abort a program that gave a public function no argument where it needs one: a bug of the caller. */
_Noreturn void clod_assert_fail_null(const char *function, const char *name);

#define CLOD_ASSERT(condition)                                                                 \
    ((condition) ? (void)0 : clod_assert_fail(#condition, __FILE__, __LINE__))
