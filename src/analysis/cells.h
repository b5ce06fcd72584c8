#pragma once
/**
 * @file cells.h
 * Numbers that may not be known, for programs: null in JSON, an empty cell in CSV.
 */

#include <stdio.h>

/** A standard error as points state it, where 0 says that none is known: NaN then.   Threads  pure. */
double clod_cells_error(double stated);

/** Write a comma and a number of ten digits; nothing behind the comma when it is NaN, which the readers of clod take as
 *  not known, and "inf".   Test  tests/cli/test_unknown_errors.py */
void clod_cells_put(FILE *out, double value);
