#pragma once
/**
 * @file check.h
 * Comparison of numbers, for cmocka (whose own works in single precision).
 */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static inline void check_close_at(double found, double expected, double tolerance,
                                  const char *file, int line)
{
    if (!(fabs(found - expected) <= tolerance)) {
        print_error("%.17g, expected %.17g within %.3g (off by %.3g)\n", found, expected,
                    tolerance, found - expected);
        _fail(file, line);
    }
}

/** |found - expected| <= tolerance; false for NaN. */
#define check_close(found, expected, tolerance)                                                \
    check_close_at((found), (expected), (tolerance), __FILE__, __LINE__)

/** The same with a tolerance relative to the expected value. */
#define check_relative(found, expected, tolerance)                                             \
    check_close_at((found), (expected), (tolerance)*fabs(expected), __FILE__, __LINE__)

/** found <= limit; false for NaN. */
#define check_at_most(found, limit)                                                            \
    do {                                                                                       \
        const double check_found = (found);                                                    \
        const double check_limit = (limit);                                                    \
        if (!(check_found <= check_limit)) {                                                   \
            print_error("%.17g, expected at most %.17g\n", check_found, check_limit);          \
            _fail(__FILE__, __LINE__);                                                         \
        }                                                                                      \
    } while (0)

#define check_at_least(found, limit) check_at_most(-(found), -(limit))
