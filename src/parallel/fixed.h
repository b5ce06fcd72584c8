#pragma once
/**
 * @file fixed.h
 * Eight sums at once in fixed point: the force, torque and power that a wall feels. The value
 * does not depend on the order of the addends, nor on how they are grouped.
 *
 * An addend is cut into three limbs, multiples of 2^0, 2^-40 and 2^-80 (of its unit: N, N m,
 * W); what is left, at most 2^-81, is dropped. Sums of such multiples are exact as long as
 * they fit in the 53 bits of a double. So any order gives the same three sums (fixed point, or
 * bins in Demmel and Nguyen, 2015, doi:10.1109/TC.2014.2345391).
 *
 * Range  an addend may be as large as 2^38 = 2.7e11; CLOD_FIXED_ADDENDS of them fit between two
 *        calls of clod_fixed_carry. A sum of 2^52 or more, or one with an addend that is not
 *        finite, is not a number.
 * Test   tests/parallel/test_fixed.c
 */

#include <math.h>
#include <stdint.h>

enum { CLOD_FIXED_LIMBS = 3, CLOD_FIXED_COLUMNS = 8, CLOD_FIXED_ADDENDS = 8192 };

/** All zero: no addend yet. */
typedef struct clod_fixed {
    _Alignas(64) double limb[CLOD_FIXED_LIMBS][CLOD_FIXED_COLUMNS];
} clod_fixed;

/** Numbers that are added and taken away again: they round to multiples of 1, 2^-40, 2^-80. */
static const double CLOD_FIXED_ROUND[CLOD_FIXED_LIMBS] = {0x1.8p52, 0x1.8p12, 0x1.8p-28};

/** Largest sum of the first limbs whose 53 bits are enough. */
#define CLOD_FIXED_MOST 0x1p52

/** Add eight numbers. Errors none. Threads one per sum. */
static inline void clod_fixed_add(clod_fixed *self, const double addend[CLOD_FIXED_COLUMNS])
{
    for (int c = 0; c < CLOD_FIXED_COLUMNS; c++) {
        double rest = addend[c];
        for (int k = 0; k < CLOD_FIXED_LIMBS; k++) {
            const double part = (rest + CLOD_FIXED_ROUND[k]) - CLOD_FIXED_ROUND[k];
            self->limb[k][c] += part;
            rest -= part;
        }
    }
}

/** Carry what is more than a limb's share into the next larger one; the value stays. */
void clod_fixed_carry(clod_fixed *self);

/** Add another sum, carried or not; this one has been carried, and is again. */
void clod_fixed_merge(clod_fixed *self, const clod_fixed *other);

/**
 * The eight sums: functions of the multiset of addends alone, within an ulp of their exact sum
 * and 2^-81 for each addend.
 *
 * @param value  [out]; not a number beyond the range
 */
void clod_fixed_value(const clod_fixed *self, double value[CLOD_FIXED_COLUMNS]);
