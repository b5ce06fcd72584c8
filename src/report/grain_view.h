#pragma once
/**
 * @file grain_view.h
 * The last snapshot of a run, to be looked at from all sides in the page.
 */

#include "report/run_files.h"
#include "report/sheet.h"

#define CLOD_GRAIN_VIEW_MOST 200000 ///< grains, and triangles, in a page

/** The view, before it is in the page. */
typedef struct clod_grain_view {
    char *data; ///< owned: JSON; NULL: there is no view
    char *note; ///< owned: HTML, what it shows
} clod_grain_view;

/**
 * Read the last snapshot of the run, of a test that of its last part; nothing when there is none, or the page
 * has no scripts. A snapshot that is missing or damaged gives no view and one more text of `run->damage`.
 *
 * @param self  [out] owned content (clod_grain_view_fini)
 * Errors  CLOD_FAILED: no memory.
 * Threads one at a time.   Test  tests/report/test_browser.py, test_damage.py
 */
bool clod_grain_view_make(clod_grain_view *self, clod_run_files *run, clod_status *status);

/** Put it into the page; nothing when there is none. */
void clod_grain_view_put(clod_sheet *sheet, const clod_grain_view *self);

/** Free the content; an empty one is fine. */
void clod_grain_view_fini(clod_grain_view *self);
