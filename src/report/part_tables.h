#pragma once
/**
 * @file part_tables.h
 * What the parts of a test measured beside their tester: means of fields over regions, mixing indices.
 */

#include "report/run_files.h"
#include "report/sheet.h"

/**
 * Put a section with a table for each field and each index, its parts side by side; nothing when there is none.
 * Grids are shown as slices (field_slices.h).
 * Test  tests/python/test_part_measures.py
 */
void clod_part_tables_put(clod_sheet *sheet, const clod_run_files *run);
