#pragma once
/**
 * @file compare_tables.h
 * Tables of a comparison: a row for each run. Those of wall friction tests are in wall_compare.h.
 */

#include <jansson.h>
#include <stdio.h>

#include "report/run_files.h"

/** The results of all shear tests, and of the laboratory (NULL: none), a row each. */
bool clod_compare_tables_shear(FILE *out, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status);

/** The same of uniaxial tests, which no laboratory stands beside. */
bool clod_compare_tables_uniaxial(FILE *out, const clod_run_files *runs, size_t count,
                                  const json_t *lab, clod_status *status);

/** The same of free runs. */
bool clod_compare_tables_free(FILE *out, const clod_run_files *runs, size_t count,
                              const json_t *lab, clod_status *status);

/** The keys whose values are not the same in all cases. Errors  CLOD_FAILED: no memory. */
bool clod_compare_tables_keys(FILE *out, const clod_run_files *runs, size_t count,
                              clod_status *status);
