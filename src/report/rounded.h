#pragma once
/**
 * @file rounded.h
 * Numbers as people read them: a value ends where its error has two digits. The whole numbers are the
 * title of the element around them.
 */

#include <stdio.h>

#include "report/writer.h"

#define CLOD_ROUNDED_SHORT 99 ///< digits of a value without an error: four, wherever they are

/** How numbers that stand side by side are written. */
typedef struct clod_rounded {
    int digits; ///< behind the point; below 0: rounded to tens, hundreds, ...
    int power;  ///< of ten that is split off, as in 1.2e-6; 0: none
} clod_rounded;

/**
 * The place of the second digit of an error, and a power of ten where the numbers would have many zeros.
 *
 * @param error   not finite, or below a millionth of the value: none, and `digits` are taken
 * @param digits  behind the point of a value without an error
 * Threads  pure.   Test  tests/report/test_rounded.c
 */
clod_rounded clod_rounded_of(double value, double error, int digits);

/** Write a number so. */
void clod_rounded_text(char text[48], clod_rounded how, double number);

/**
 * Write a value, " ± error", its unit and " (s scatter)", small on a page; those that are not finite are left out, and an
 * error that is none. @param unit  "": none
 */
void clod_rounded_put(clod_writer out, double value, double error, double scatter, int digits,
                      const char *unit);

/** Begin an element whose title is the whole value, with its error and unit where there are any. */
void clod_rounded_begin(FILE *out, const char *tag, double value, double error,
                        const char *unit);
