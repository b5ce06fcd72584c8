#pragma once
/**
 * @file exact.h
 * A sum without rounding: its value does not depend on the order or the grouping of what is
 * added, so threads (and later ranks) may add what they have and merge it in any order.
 *
 * Every finite double is an integer multiple of 2^-1075. The sum is kept as such an integer, in
 * chunks of 32 bits, each with room in a 64-bit word for the carries of many additions. It is
 * rounded once, to the nearest double, when it is asked for.
 *
 * Source  R. M. Neal, Fast exact summation using small and large superaccumulators,
 *         arXiv:1505.05571 (2015), section 3: the small one.
 * Test    tests/parallel/test_exact.c
 */

#include <stdbool.h>
#include <stdint.h>

/** Words of 32 bits from 2^-1075 up to beyond the largest double, and two for the sum. */
#define CLOD_EXACT_CHUNKS 67

/** All zero is the sum of nothing. */
typedef struct clod_exact {
    int64_t chunk[CLOD_EXACT_CHUNKS]; ///< the sum is that of chunk[k] 2^(32 k - 1075)
    int32_t pending;                  ///< additions whose carries are still in their chunks
    bool nan, plus_infinity, minus_infinity;
} clod_exact;

/** Add a number. Infinities and NaN count as they do in a sum of doubles. */
void clod_exact_add(clod_exact *self, double number);

/** Add another sum. */
void clod_exact_merge(clod_exact *self, const clod_exact *other);

/** Bring a sum into the one form that every equal sum has: its bytes can be compared and kept. */
void clod_exact_settle(clod_exact *self);

/** The sum, rounded to the nearest double, ties to even; +0 when it is zero. */
double clod_exact_value(const clod_exact *self);
