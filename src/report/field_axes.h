#pragma once
/**
 * @file field_axes.h
 * Along which axes the means of fields have their vectors and tensors: the summary has their numbers,
 * the case their axes.
 */

#include "report/run_files.h"

/**
 * Set `components: cylindrical` in what the summary, and each part in it, has of the fields whose case
 * asks for it.
 *
 * @param run  its summary may be NULL; a case that cannot be read asks for nothing
 * Threads  one per run.   Test  tests/report/test_page.py
 */
void clod_field_axes_set(const clod_run_files *run);
