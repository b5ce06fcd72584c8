#pragma once
/**
 * @file warnings_section.h
 * The warnings of a page, and of its runs in the terminal: those that say the same of other numbers, of other parts or other runs are one.
 */

#include <jansson.h>

#include "report/run_files.h"
#include "report/writer.h"

/**
 * Write the section with all warnings of runs, in the order in which they come, and of the laboratory's points; without any
 * that there is none, where runs of this kind are checked.
 *
 * @param compared  warnings are called by their runs, and those that differ in numbers alone are one too (clod compare);
 *                  else by their parts
 * @param lab       the laboratory's results; NULL: none
 * Errors  CLOD_FAILED: no memory.   Test  tests/report/test_compare.py, tests/report/test_shear_page.py
 */
bool clod_warnings_section_put(clod_writer out, const clod_run_files *runs, size_t count,
                               bool compared, const json_t *lab, clod_status *status);
