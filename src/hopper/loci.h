#pragma once
/**
 * @file loci.h
 * Shear tests that a hopper's case names: their yield loci as rows of a flow function.
 */

#include <limits.h>
#include <stdint.h>

#include "hopper/joint.h"
#include "hopper/specimens.h"
#include "hopper/tables.h"

/** A row of the flow function; 0: not there. */
typedef struct clod_loci_row {
    clod_curve_point strength, phi_e, phi_t,
        rho;                   ///< x, and what belongs to it, in strength alone
    double tau_p, tau_p_error; ///< of preshear, from a table of loci
    int64_t seeds;             ///< specimens, from a table of loci; 0: not told
    double correlation
        [CLOD_JOINT_PAIRS]; ///< of the errors of sigma_1, f_c, phi_e, phi_t; NAN: not known
} clod_loci_row;

/** The loci of shear tests. */
typedef struct clod_loci {
    clod_loci_row *rows; ///< [count] owned (clod_loci_fini)
    size_t count;
    clod_specimens specimens; ///< owned; what moves the rows together
} clod_loci;

/**
 * Evaluate the points of all shear tests of a case together, as clod locus does.
 *
 * @param loci   [out] owned content (clod_loci_fini), also after an error
 * @param notes  [in, out]
 * Errors  CLOD_USAGE: as clod_locus_read, clod_locus_study_create and clod_angles_check, and no
 *         strength, or no phi_e.
 * Threads safe.   Test  tests/hopper/test_measured.py, test_refusals.py
 */
bool clod_loci_read(const clod_hopper_case *of, clod_loci *loci, clod_tables_notes *notes,
                    clod_status *status);

/**
 * Let the values of a row move together, where a correlation of their errors is known.
 *
 * @return  false: there are no errors with such correlations
 */
bool clod_loci_join(clod_loci_row *row);

/** Free the content; loci of zeros are fine. */
void clod_loci_fini(clod_loci *self);

/** The file itself, or the table of this name in a results folder, which must have it. */
bool clod_loci_find(const char *path, const char *table, char inside[PATH_MAX],
                    clod_status *status);
