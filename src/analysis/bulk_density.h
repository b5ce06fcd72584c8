#pragma once
/**
 * @file bulk_density.h
 * What is asked of a bulk density.
 */

#include "analysis/csv.h"
#include "clod/locus.h"

#define CLOD_BULK_DENSITY_LEAST                                                                \
    10.0 ///< kg/m3: aerogels and foam beads, the lightest, pour with more
#define CLOD_BULK_DENSITY_MOST 15000.0 ///< kg/m3: powders of tungsten and platinum are lighter

#define CLOD_BULK_DENSITY_LIGHT                                                                \
    100.0 ///< kg/m3: below it are few solids, and most that are measured in lb/ft3

/** Warn of a density so low that its unit may be lb/ft3.
 *
 * @param rho   kg/m3; NAN: none
 * @param text  [out] "": all is well
 * @return      whether there is a warning
 * Errors  none.   Threads  pure.   Test  tests/analysis/test_bulk_density.c
 */
bool clod_bulk_density_warn(double rho, char text[CLOD_LOCUS_WARNING_TEXT]);

/** Whether a solid can pour with such a density [kg/m3]. Threads  pure. */
bool clod_bulk_density_is_usual(double rho);

/**
 * Whether a density was measured under a stress: a power law has none at 0, nor a simulated test.
 *
 * @param path  the table, as messages name it
 * Errors  CLOD_USAGE.   Threads  pure.   Test  tests/analysis/test_bulk_density.c
 */
bool clod_bulk_density_consolidated(const char *path, double sigma_1, clod_status *status);

/**
 * Whether a solid can pour with such a density; else it is the unit.
 *
 * @param self  the table that is read: messages say where
 * @param column  its name
 * @param rho   kg/m3
 * Errors  CLOD_USAGE.   Threads  pure.   Test  tests/analysis/test_bulk_density.c
 */
bool clod_bulk_density_check(const clod_csv *self, const char *column, double rho);
