#pragma once
/**
 * @file prose.h
 * Pieces of the tables for people.
 */

#include <stdio.h>

/** A number in a column of `width`; "-" when it is none. */
void clod_prose_number(FILE *out, int width, int digits, double value);

/** A standard error in a column of `width`; one that is too small for the digits but not 0 is
 *  "<0.001"; "-" when it is none. */
void clod_prose_error(FILE *out, int width, int digits, double value);

/**
 * Text behind a value written with "%.4g": " +- 0.12", its standard deviation; one below half the value's last
 * digit but not 0, which may be the rounding of equal numbers, is " +- <0.001"; "" when it is none.
 *
 * @param text  [out] what is returned
 * Test  tests/analysis/test_prose.c
 */
const char *clod_prose_deviation(char text[32], double value, double deviation);

/** A warning, broken between words; lines after the first are indented. */
void clod_prose_warning(FILE *out, const char *text);
