#pragma once
/**
 * @file tables.h
 * The tables that a hopper's case names, as curves of the solid.
 */

#include "base/warning_list.h"
#include "hopper/case.h"
#include "hopper/solid.h"

/** What is to be said beside what was read. */
typedef struct clod_tables_notes {
    const char *
        specimen; ///< of a strength of one specimen, clod_locus_specimen_note; NULL: of several
    bool preshear_untold;        ///< whether the error of a tau_p is not known (clod/locus.h)
    bool uniaxial;               ///< whether the flow function is that of a uniaxial test
    clod_warning_list *warnings; ///< those of yield loci and of wall yield loci
} clod_tables_notes;

/**
 * Read everything measured.
 *
 * @param solid        [out] owned points (clod_tables_fini), also after an error
 * @param notes        [in, out]
 * Errors  CLOD_USAGE with file, line, column, value and what to do; CLOD_FAILED: memory.
 * Threads safe.   Test  tests/hopper/test_measured.py, test_refusals.py
 */
bool clod_tables_read(const clod_hopper_case *from, clod_solid *solid, clod_tables_notes *notes,
                      clod_status *status);

/**
 * Read a flow function: sigma_1 and f_c (sigma_c), and what else its columns give.
 *
 * @param solid  [in, out] zeros before; owned points (clod_tables_fini) in the order of the table,
 *               also after an error
 * @param notes  [in, out]
 * Errors, threads, test  as clod_tables_read.
 */
bool clod_tables_read_flow(const char *path, clod_solid *solid, clod_tables_notes *notes,
                           clod_status *status);

/**
 * Give strengths that state no error that of their scatter; where the curve goes from point to point, put one in place of repeats.
 *
 * @param strength  [in, out] sorted
 * @param what      whose repeats are warned of: "Flow function"
 * Errors  CLOD_FAILED: memory.   Threads safe.   Test  tests/hopper/test_strength.py
 */
bool clod_tables_take_scatter(clod_curve *strength, const char *what, clod_tables_notes *notes,
                              clod_status *status);

/** The same of bulk densities: sigma_1 and rho_b; the curve's points are owned (clod_curve_fini). */
bool clod_tables_read_density(const char *path, clod_curve *curve, clod_status *status);

/** Free the points; a solid of zeros is fine. */
void clod_tables_fini(clod_solid *solid);
