#pragma once
/**
 * @file calibration_page.h
 * The page of a calibration: what clod calibrate left in its folder.
 */

#include <stdbool.h>

#include "report/sheet.h"

/** Whether a folder is that of a finished calibration. */
bool clod_calibration_page_is(const char *folder);

/**
 * Put its warnings, tables and figures into a page that is open.
 *
 * @param title  [out] owned title of the page (clod_memory_free); NULL after an error
 * Errors  CLOD_USAGE: a damaged file; CLOD_FAILED: disk, memory.
 * Threads one per sheet.   Test  tests/calibrate/test_calibrate.py
 */
bool clod_calibration_page_put(clod_sheet *sheet, const char *folder, char **title,
                               clod_status *status);
