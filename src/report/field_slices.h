#pragma once
/**
 * @file field_slices.h
 * Slices through the grids of a run's fields, as figures: density, pressure, speed with arrows,
 * coordination.
 */

#include "report/run_files.h"
#include "report/sheet.h"

/**
 * Put a section with the slices of every field_NAME.hdf of the folder; nothing when there is none.
 * Errors  CLOD_USAGE: a damaged file; CLOD_FAILED: memory.   Test  tests/python/test_slices.py
 */
bool clod_field_slices_put(clod_sheet *sheet, const clod_run_files *run, clod_status *status);

/**
 * The same of a test: those of the first part that shears or crushes its specimen, the preshear of a
 * shear test.
 * Errors  as above.   Test  tests/python/test_part_measures.py
 */
bool clod_field_slices_put_part(clod_sheet *sheet, const clod_run_files *run,
                                clod_status *status);
