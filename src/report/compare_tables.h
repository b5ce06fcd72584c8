#pragma once
/**
 * @file compare_tables.h
 * Tables of a comparison: results of runs, of a laboratory, and means of runs that differ in their seeds
 * alone.
 */

#include <jansson.h>
#include <stdio.h>

#include "report/result_table.h"
#include "report/run_files.h"

/** The results of all shear tests, and of the laboratory (NULL: none). Errors  CLOD_FAILED: no memory. */
bool clod_compare_tables_shear(FILE *out, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status);

/** The same of wall friction tests. */
bool clod_compare_tables_wall(FILE *out, const clod_run_files *runs, size_t count,
                              const json_t *lab, clod_status *status);

/** The same of uniaxial tests, which no laboratory stands beside. */
bool clod_compare_tables_uniaxial(FILE *out, const clod_run_files *runs, size_t count,
                                  const json_t *lab, clod_status *status);

/** Object number g of a run's summary; NULL behind the last. */
typedef const json_t *(*clod_compare_object)(const json_t *summary, size_t g);

/**
 * The table of objects of all runs, with the means of those that differ in their seeds alone.
 *
 * @param lab  a summary with the laboratory's objects; NULL: none
 * Errors  CLOD_FAILED: no memory.
 */
bool clod_compare_tables_put(FILE *out, const clod_result_row *rows, size_t row_count,
                             const clod_run_files *runs, size_t count, const json_t *lab,
                             clod_compare_object get, clod_status *status);
