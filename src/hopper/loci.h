#pragma once
/**
 * @file loci.h
 * Shear tests that a hopper's case names: their yield loci as rows of a flow function.
 */

#include <limits.h>

#include "hopper/tables.h"

/** A row of the flow function; 0: not there. */
typedef struct clod_loci_row {
    clod_curve_point strength, phi_e, phi_t, rho; ///< x: sigma_1, in strength alone
} clod_loci_row;

/**
 * Evaluate the points of all shear tests of a case together, as clod locus does.
 *
 * @param rows   [out] clod_loci_row [count], owned (clod_memory_free)
 * @param notes  [in, out]
 * Errors  CLOD_USAGE: as clod_locus_read, clod_locus_study_create and clod_angles_check, and no
 *         strength, or no phi_e.
 * Threads safe.   Test  tests/hopper/test_measured.py, test_refusals.py
 */
bool clod_loci_read(const clod_hopper_case *of, void **rows, size_t *count,
                    clod_tables_notes *notes, clod_status *status);

/** The file itself, or the table of this name in a results folder, which must have it. */
bool clod_loci_find(const char *path, const char *table, char inside[PATH_MAX],
                    clod_status *status);
