#pragma once
/**
 * @file compare_tables.h
 * Tables of a comparison: results of runs, of a laboratory, and means of runs that differ in their seeds
 * alone.
 */

#include <jansson.h>

#include "report/result_table.h"
#include "report/run_files.h"
#include "report/writer.h"

/** The results of all shear tests, and of the laboratory (NULL: none). Errors  CLOD_FAILED: no memory. */
bool clod_compare_tables_shear(clod_writer out, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status);

/** The same of wall friction tests. */
bool clod_compare_tables_wall(clod_writer out, const clod_run_files *runs, size_t count,
                              const json_t *lab, clod_status *status);

/** The same of uniaxial tests, which no laboratory stands beside. */
bool clod_compare_tables_uniaxial(clod_writer out, const clod_run_files *runs, size_t count,
                                  const json_t *lab, clod_status *status);

/** Object number g of a run's summary; NULL behind the last. */
typedef const json_t *(*clod_compare_object)(const json_t *summary, size_t g);

/** A table of a comparison: the next `rows` of all. */
typedef struct clod_compare_table {
    const char *title; ///< NULL: none
    const char *note;  ///< below it; NULL: none
    size_t rows;
} clod_compare_table;

/** The tables of objects, and their rows. */
typedef struct clod_compare_tables {
    const clod_compare_table *table; ///< [count]
    size_t count;
    const clod_result_row
        *rows; ///< [row_count]: those of the tables, one table after the other
    size_t row_count;
    clod_compare_object get;
} clod_compare_tables;

/**
 * The tables of objects of all runs, with the means of those that differ in their seeds alone.
 *
 * @param lab  a summary with the laboratory's objects; NULL: none
 * Errors  CLOD_FAILED: no memory.
 */
bool clod_compare_tables_put(clod_writer out, const clod_compare_tables *self,
                             const clod_run_files *runs, size_t count, const json_t *lab,
                             clod_status *status);
