#pragma once
/**
 * @file hopper_figures.h
 * The figures of a design: curves with the points they go through, critical states with their
 * intervals, outlets of the samples.
 */

#include "hopper/result.h"
#include "report/sheet.h"

/** Put all of them into a page. Errors  the sheet's `lost`.
 *  Test  tests/report/test_hopper_page.py */
void clod_hopper_figures_put(clod_sheet *sheet, const clod_hopper *design);
