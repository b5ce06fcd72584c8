#pragma once
/**
 * @file grain_view.h
 * The last snapshot of a run, to be looked at from all sides in the page.
 */

#include "report/run_files.h"
#include "report/sheet.h"

#define CLOD_GRAIN_VIEW_MOST 200000 ///< grains, and triangles, in a page

/**
 * Put the last snapshot of the run, of a test that of its last part, into the page; nothing when
 * there is none, or the page has no scripts.
 * Errors  CLOD_USAGE: a damaged snapshot; CLOD_FAILED: no memory.
 * Threads one at a time.   Test  tests/report/test_browser.py
 */
bool clod_grain_view_put(clod_sheet *sheet, const clod_run_files *run, clod_status *status);
