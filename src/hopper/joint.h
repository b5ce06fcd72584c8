#pragma once
/**
 * @file joint.h
 * Values of one yield locus, whose errors go together: sigma_1, f_c, phi_e, phi_t, in this order.
 */

#include <stdbool.h>
#include <stddef.h>

#include "hopper/curve.h"
#include "hopper/solid.h"

#define CLOD_JOINT_PAIRS (CLOD_CURVE_JOINT * (CLOD_CURVE_JOINT - 1) / 2)

/**
 * What each value moves by per standard normal number of the locus: the factor L of L L' = the covariance. The
 * first number moves the first value with an error, the others what is left.
 *
 * @param error        standard errors; 0: the value is exact, or is not there
 * @param correlation  of the errors: 1 with 2, 3, 4; 2 with 3, 4; 3 with 4; NAN: not known, taken as 0
 * @param part         [out]
 * @return             false: there are no such errors
 * Errors  none.   Threads  pure.   Source  docs/theory/hopper.md.   Test  tests/hopper/test_joint.c
 */
bool clod_joint_factor(const double error[CLOD_CURVE_JOINT],
                       const double correlation[CLOD_JOINT_PAIRS],
                       double part[CLOD_CURVE_JOINT][CLOD_CURVE_JOINT]);

/** How the loci of a solid are drawn: rows of the flow function with several errors. */
typedef struct clod_joint_rows {
    size_t together; ///< by the correlations of their errors
    size_t apart;    ///< independently: their correlations are not known
} clod_joint_rows;

/** Count them, those of several specimens not among them. Threads  pure.   Test  tests/hopper/test_loci.py */
clod_joint_rows clod_joint_count(const clod_solid *solid);
