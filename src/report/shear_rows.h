#pragma once
/**
 * @file shear_rows.h
 * The results of a yield locus as rows of the page's tables.
 */

#include <jansson.h>
#include <stdio.h>

#include "report/result_table.h"

#define CLOD_SHEAR_ROW_COUNT 16 ///< the last two: class of flow, fit of the line

extern const clod_result_row CLOD_SHEAR_ROWS[CLOD_SHEAR_ROW_COUNT];

/** As clod_result_table_number. */
double clod_shear_number(const json_t *object, const char *key);

/** Yield locus g of a study, borrowed; NULL behind the last. */
const json_t *clod_shear_locus(const json_t *study, size_t g);

/** The row with this key, one of CLOD_SHEAR_ROWS. */
const clod_result_row *clod_shear_row_of(const char *key);
