#pragma once
/**
 * @file warnings.h
 * What is not right with a yield locus.
 */

#include "analysis/fit.h"
#include "clod/locus.h"

/** Of the preshear stress: normal stresses no further apart are the same, no servo is better.
 */
#define CLOD_WARNINGS_SAME_STRESS 0.01

/** Relative: preshear stresses further apart are two consolidations. */
#define CLOD_WARNINGS_SAME_PRESHEAR 0.02

// deg; angles of dry and of very rough solids lie well inside
#define CLOD_WARNINGS_PHI_LOW 5.0
#define CLOD_WARNINGS_PHI_HIGH 65.0

/** The line and the prorated points it goes through. */
typedef struct clod_warnings_line {
    clod_fit fit;
    const double *x, *y; ///< [count]
    size_t count;
} clod_warnings_line;

/** Add a warning; when there is no room left, the last one says so. */
void clod_warnings_add(clod_locus *locus, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** Whether a solid may have a yield locus of this angle [rad]: 5 to 65 deg. */
bool clod_warnings_is_usual(double phi_lin);

/** Warn when the angles of several seeds, whose mean the locus is, differ too much. */
void clod_warnings_check_seeds(clod_locus *locus);

/**
 * Look at an evaluated locus and its points and add warnings.
 *
 * @param locus   [in,out] complete but for its warnings
 * @param points  [count] it was evaluated from
 * @param line    through the prorated points
 * Test  tests/analysis/test_warnings.c
 */
void clod_warnings_check(clod_locus *locus, const clod_locus_point *points, size_t count,
                         const clod_warnings_line *line);

/** Strength after a consolidation. */
typedef struct clod_warnings_strength {
    double stress;   ///< of the consolidation [Pa]
    double strength; ///< sigma_c [Pa]; NAN where there is none
    double error;    ///< standard error of sigma_c; NAN = not known
} clod_warnings_strength;

/**
 * Remark on a strength that falls while the consolidation rises: of all pairs the one that
 * falls most, when that is more than 2 % of the strength.
 *
 * @param points  [count] in any order
 * @param text    [out] the remark; "" when nothing falls
 * Test  tests/analysis/test_study.c
 */
void clod_warnings_strength_falls(const clod_warnings_strength *points, size_t count,
                                  char text[CLOD_LOCUS_WARNING_TEXT]);
