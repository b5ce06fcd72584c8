#pragma once
/**
 * @file hopper_page.h
 * The page of a hopper's design.
 */

#include "hopper/result.h"
#include "report/sheet.h"

/**
 * Put a design into a page that is open: warnings first, those that differ in numbers alone as one, then
 * what to build, figures, numbers and where they come from. Every number's title is the one of the design's JSON.
 *
 * Errors  the sheet's `lost`.   Threads  one per sheet.   Test  tests/report/test_hopper_page.py
 */
void clod_hopper_page_put(clod_sheet *sheet, const clod_hopper *design);

/** Its title; borrowed. */
const char *clod_hopper_page_title(const clod_hopper *design);
