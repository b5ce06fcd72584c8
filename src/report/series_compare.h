#pragma once
/**
 * @file series_compare.h
 * Curves of several runs over each other.
 */

#include "report/run_files.h"
#include "report/sheet.h"

/** A column of the parts whose names hold `part`, over another. Errors  CLOD_USAGE: a damaged table. */
bool clod_series_compare_parts(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                               const char *part, const char *over, const char *column,
                               clod_status *status);

/** Flow functions of uniaxial tests, and their axial stresses. Errors  as above. */
bool clod_series_compare_strengths(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                                   clod_status *status);

/** The columns of free runs that matter most and that all have, one figure each. Errors  as above.
 */
bool clod_series_compare_free(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                              clod_status *status);
