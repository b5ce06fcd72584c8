#pragma once
/**
 * @file shear_rows.h
 * The results of a yield locus as rows of the page's tables.
 */

#include <jansson.h>
#include <stdio.h>

#define CLOD_SHEAR_ROW_COUNT 11

typedef struct clod_shear_row {
    const char *key;    ///< of the JSON
    const char *text;   ///< HTML
    const char *symbol; ///< HTML
    const char *unit;   ///< HTML
    double factor;      ///< brings the JSON's number to this unit
    int digits;         ///< behind the point, as in report.txt
} clod_shear_row;

extern const clod_shear_row CLOD_SHEAR_ROWS[CLOD_SHEAR_ROW_COUNT];

/** A number, or the `value` of an object with one; NaN where there is none. */
double clod_shear_number(const json_t *object, const char *key);

/** Yield locus g of a study, borrowed; NULL behind the last. */
const json_t *clod_shear_locus(const json_t *study, size_t g);

/** Write a result with its error and scatter, as HTML. */
void clod_shear_value(FILE *out, const json_t *locus, const clod_shear_row *row);

/** The row with this key, one of CLOD_SHEAR_ROWS. */
const clod_shear_row *clod_shear_row_of(const char *key);
