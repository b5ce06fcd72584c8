#pragma once
/**
 * @file bulk_density.h
 * What all readers of bulk densities ask of one.
 */

#include "analysis/csv.h"

/**
 * Whether a solid can pour with such a density; else it is the unit.
 *
 * @param self  the table that is read: messages say where
 * @param column  its name
 * @param rho   kg/m3
 * Errors  CLOD_USAGE.   Threads  pure.   Test  tests/analysis/test_bulk_density.c
 */
bool clod_bulk_density_check(const clod_csv *self, const char *column, double rho);
