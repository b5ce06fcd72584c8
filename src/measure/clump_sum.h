#pragma once
/**
 * @file clump_sum.h
 * Sums over the grains of a clump in fixed point: multiples of the largest number of the bed over
 * 2^90, so any grouping gives the same bits, and numbers down to 2^-37 of the largest lose none.
 *
 * Range  2^31 numbers.   Test  tests/measure/test_clumps.c
 */

#include <math.h>

/** All zero: the sum of nothing. */
__extension__ typedef __int128 clod_clump_sum;

/** Bits of the largest number. */
#define CLOD_CLUMP_SUM_BITS 91

/** The unit of sums of numbers of which none is larger [the number's unit]. Threads: pure. */
static inline double clod_clump_sum_unit(double largest)
{
    int exponent;
    frexp(largest, &exponent); // the number is below 2^exponent
    return ldexp(1.0, exponent - CLOD_CLUMP_SUM_BITS);
}

/** A number, 0 or more, in such units; what is less than one is dropped. Threads: pure. */
static inline clod_clump_sum clod_clump_sum_of(double number, double unit)
{
    return (clod_clump_sum)(number / unit);
}

/** A sum, rounded to the nearest double. Threads: pure. */
static inline double clod_clump_sum_value(clod_clump_sum sum, double unit)
{
    return (double)sum * unit;
}
