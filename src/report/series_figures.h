#pragma once
/**
 * @file series_figures.h
 * The columns of a series as figures: those of one quantity and unit in one, a curve each.
 */

#include "report/sheet.h"
#include "report/table.h"

/** Put in those that matter most, or all others; columns that never change are left out.
 *  Errors  the sheet is lost without memory.   Test  tests/report/test_free_page.py */
void clod_series_figures_put(clod_sheet *sheet, const clod_table *series, bool main);

/** Put in what fields measured in a part of a test, over its displacement or strain.
 *  Errors  the sheet is lost without memory.   Test  tests/report/test_page.py */
void clod_series_figures_fields(clod_sheet *sheet, const clod_table *part);

/** All columns with this unit in one figure over time. */
void clod_series_figures_all(clod_sheet *sheet, const clod_table *table, const char *name,
                             const char *title, const char *unit);
