#pragma once
/**
 * @file wall_compare.h
 * Wall friction tests beside each other, and the laboratory's.
 */

#include <jansson.h>

#include "report/run_files.h"
#include "report/sheet.h"

/** Wall yield loci over each other, and the curves of all. Errors  CLOD_USAGE: a damaged table; CLOD_FAILED: no memory. */
bool clod_wall_compare_figures(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status);
