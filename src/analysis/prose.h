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

/** A warning, broken between words; lines after the first are indented. */
void clod_prose_warning(FILE *out, const char *text);
