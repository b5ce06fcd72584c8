#pragma once
/**
 * @file part_tables.h
 * What the parts of a test measured beside their tester: means of fields over regions, mixing indices.
 */

#include "report/run_files.h"
#include "report/sheet.h"

/**
 * Put a section with a table for each field and each index, its parts side by side, and the curves of the
 * fields of one part; nothing when there is none. Grids, and which part that is: field_slices.h.
 *
 * Errors  CLOD_USAGE: a damaged table.
 * Test    tests/python/test_part_measures.py, tests/report/test_page.py
 */
bool clod_part_tables_put(clod_sheet *sheet, const clod_run_files *run, clod_status *status);
