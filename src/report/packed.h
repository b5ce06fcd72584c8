#pragma once
/**
 * @file packed.h
 * Arrays of numbers as text in a page: 16 bits each between their least and greatest, in base64.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/** Write bytes in base64. Source  RFC 4648, section 4. Test  tests/report/test_packed.c */
void clod_packed_base64(FILE *out, const unsigned char *bytes, size_t count);

/**
 * Write numbers as JSON, {"min": ..., "max": ..., "data": "..."}: number k stands for min +
 * (max - min) k / 65535, in two bytes, the lower one first. Not finite ones stand for min. Without
 * data all are min.
 *
 * @param value  [count * stride], of which every stride-th is written
 * @return       whether there was memory for it
 * Test    tests/report/test_packed.c
 */
bool clod_packed_numbers(FILE *out, const double *value, size_t count, size_t stride);
