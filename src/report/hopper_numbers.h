#pragma once
/**
 * @file hopper_numbers.h
 * The lower part of a design's page: tables of its numbers, of what spreads them, of what was
 * measured, and where it comes from.
 */

#include <stdio.h>

#include "hopper/result.h"

/** Write all of it. Threads  one per stream.   Test  tests/report/test_hopper_page.py */
void clod_hopper_numbers_put(FILE *out, const clod_hopper *design);
