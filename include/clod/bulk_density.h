#pragma once
/**
 * @file bulk_density.h
 * Bulk density over consolidation stress: points, and the power law of Jenike through them. A
 * NULL where an argument is needed: see clod/status.h.
 */

#include "clod/locus.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Bulk density at one consolidation stress; errors: 0 = not stated. */
typedef struct clod_bulk_density_point {
    double sigma_1;       ///< major principal stress of consolidation [Pa]
    double rho_b;         ///< bulk density [kg/m3]
    double sigma_1_error; ///< standard error [Pa]
    double rho_b_error;   ///< standard error [kg/m3]
} clod_bulk_density_point;

#define CLOD_BULK_DENSITY_WARNINGS 4

/** rho_b = rho_1 (sigma_1/1 kPa)^compressibility. */
typedef struct clod_bulk_density {
    clod_locus_value rho_1;           ///< kg/m3, at 1 kPa
    clod_locus_value compressibility; ///< exponent
    double r_squared;                 ///< of the line through the logarithms
    size_t point_count;
    clod_bulk_density_point *points; ///< [point_count] owned, in ascending order of sigma_1
    size_t warning_count;
    char warnings[CLOD_BULK_DENSITY_WARNINGS][CLOD_LOCUS_WARNING_TEXT]; ///< what is not right
} clod_bulk_density;

/**
 * Fit the power law: a line through the logarithms by least squares; errors from those
 * of the points and what they scatter about it beyond, NAN with two points that state none.
 *
 * @param points  [count] two at least, with different sigma_1, all above 0
 * @param self    [out] owned content (clod_bulk_density_fini); what is not right is in its warnings
 * Errors  CLOD_USAGE: a NULL, too few points; CLOD_FAILED: memory.   Threads  pure.
 * Source  Jenike, Bulletin 123 (1964).   Test  tests/analysis/test_bulk_density.c
 */
bool clod_bulk_density_evaluate(const clod_bulk_density_point *points, size_t count,
                                clod_bulk_density *self, clod_status *status);

/** Free the content; an empty one is fine, NULL is not. */
void clod_bulk_density_fini(clod_bulk_density *self);

/**
 * Read a table from a CSV file with units in its header.
 *
 * @param path    the file: columns sigma_1 (0: loose), rho_b and, optional, sigma_1_error, rho_b_error
 * @param points  [out] owned (clod_locus_free)
 * Errors  CLOD_USAGE with file:line, column, value and what to do.   Threads  safe.
 * Test    tests/analysis/test_bulk_density.c
 */
bool clod_bulk_density_parse(const char *path, const char *text, size_t length,
                             clod_bulk_density_point **points, size_t *count,
                             clod_status *status);

/** A table for people, everything as JSON, one row per point as CSV; owned (clod_locus_free),
 *  or NULL. */
char *clod_bulk_density_table(const clod_bulk_density *self);
char *clod_bulk_density_json(const clod_bulk_density *self);
char *clod_bulk_density_csv(const clod_bulk_density *self);

#ifdef __cplusplus
}
#endif
