#pragma once
/**
 * @file field_slices.h
 * Slices through the grids of a run's fields, as figures: density, pressure, speed with arrows,
 * coordination. Those of a test are the grids of its first part that shears or crushes its specimen,
 * the preshear of a shear test.
 */

#include <jansson.h>

#include "report/run_files.h"
#include "report/sheet.h"

/**
 * What the summary has of the grids that are shown, by the name of their fields; borrowed, NULL: none.
 * Means over regions, which have no corner, are among those of a free run.
 *
 * @param part  [out] of a test; NULL: a free run
 */
json_t *clod_field_slices_grids(const clod_run_files *run, const char **part);

/** Path of a grid's file. @param part  of a test; NULL: a free run */
void clod_field_slices_path(const clod_run_files *run, const char *part, const char *field,
                            char *path, size_t size);

/**
 * Put a section with the slices of every grid; nothing when there is none.
 * Errors  CLOD_USAGE: a damaged file; CLOD_FAILED: memory.
 * Test    tests/python/test_slices.py, tests/python/test_part_measures.py
 */
bool clod_field_slices_put(clod_sheet *sheet, const clod_run_files *run, clod_status *status);
