#pragma once
/**
 * @file compare_tables.h
 * Tables of a comparison: results of runs, of a laboratory, and means of runs that differ in their seeds
 * alone.
 */

#include <jansson.h>
#include <stdio.h>

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

/** The same of free runs. */
bool clod_compare_tables_free(FILE *out, const clod_run_files *runs, size_t count,
                              const json_t *lab, clod_status *status);
