#pragma once
/**
 * @file locus.h
 * Evaluation of shear tests: points -> yield locus, Mohr circles, flow function.
 * Knows no simulation: points may be simulated or measured. docs/theory/yield-locus.md has the
 * equations and says what the error bars mean. A NULL where an argument is needed: see
 * clod/status.h.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * One shear point with its preshear. Stresses in Pa; errors: 0 = not stated. Points of one seed
 * and sigma_p that all tell the same tau_p, rho_b and errors of both (and rho_inside, where told) stem from one preshear;
 * otherwise each has its own (docs/theory/yield-locus.md).
 */
typedef struct clod_locus_point {
    int64_t seed;       ///< which repeat of the whole test; 0 = not told
    double sigma_p;     ///< normal stress of preshear
    double tau_p;       ///< steady shear stress of preshear
    double sigma_s;     ///< normal stress at shear to failure
    double tau_s;       ///< peak shear stress
    double rho_b;       ///< bulk density at the end of preshear [kg/m3]; 0 = not known
    double tau_p_error; ///< standard error of tau_p; once for the points of one preshear
    double tau_s_error; ///< standard error of tau_s
    double rho_b_error; ///< standard error of rho_b
    double rho_inside;  ///< bulk density away from the walls of the cell [kg/m3]; 0 = not known
    size_t row;         ///< line of the file that it was read from; 0 = none
} clod_locus_point;

/** A result: NAN where it is not defined or not known. */
typedef struct clod_locus_value {
    double value;
    double error;   ///< standard error
    double scatter; ///< standard deviation between seeds; NAN for a single one
} clod_locus_value;

/** A shear point as the line sees it [Pa]. */
typedef struct clod_locus_mark {
    int64_t seed;
    double sigma;    ///< normal stress
    double measured; ///< tau_s as it came
    double error;    ///< standard error stated for it; 0 = none
    double prorated; ///< tau_s mean(tau_p) / tau_p
    double line;     ///< the fitted line at sigma
    size_t index;    ///< of its point, among those that were given
} clod_locus_mark;

/** A Mohr circle [Pa]; NAN where it does not exist. */
typedef struct clod_locus_circle {
    double centre, radius;
} clod_locus_circle;

/** Where the standard errors come from. */
typedef enum clod_locus_errors {
    CLOD_LOCUS_ERRORS_NONE,  ///< fewer than three points and no stated errors: none are known
    CLOD_LOCUS_ERRORS_FIT,   ///< one test: scatter about the line and stated errors, propagated
    CLOD_LOCUS_ERRORS_SEEDS, ///< several tests: scatter of their loci
} clod_locus_errors;

/** Pairs of the values whose errors are told together: sigma_1 with sigma_c, phi_e and phi_lin; sigma_c with
 *  phi_e and phi_lin; phi_e with phi_lin. */
#define CLOD_LOCUS_PAIRS 6

#define CLOD_LOCUS_WARNINGS 24
#define CLOD_LOCUS_WARNING_TEXT 256

/** A yield locus tau = c + sigma tan(phi_lin), and what follows from it. Stresses in Pa. */
typedef struct clod_locus {
    clod_locus_value sigma_p, tau_p; ///< mean preshear point
    clod_locus_value c;              ///< cohesion
    clod_locus_value phi_lin;        ///< angle of the line [rad]
    clod_locus_value phi_e;          ///< effective angle of internal friction [rad]
    clod_locus_value phi_sf;         ///< angle of internal friction at steady flow [rad]
    clod_locus_value sigma_1;        ///< major principal stress at steady flow
    clod_locus_value sigma_2;        ///< minor principal stress at steady flow
    clod_locus_value sigma_c;        ///< unconfined yield strength; NAN when c < 0
    clod_locus_value ffc;            ///< sigma_1/sigma_c; INFINITY when c = 0, NAN when c < 0
    clod_locus_value rho_b;          ///< bulk density [kg/m3]
    clod_locus_value rho_inside;  ///< bulk density away from the walls of the cell [kg/m3]; of
                                  ///< several seeds the mean of those that tell it
    double r_squared;             ///< of the line; the smallest of the seeds
    bool parallel;                ///< sigma_1 by the parallel line: preshear above the locus
    const char *flow;             ///< Jenike's class in words; static
    clod_locus_circle steady;     ///< through sigma_1 and sigma_2
    clod_locus_circle unconfined; ///< through sigma_c and the origin
    clod_locus_errors errors;
    bool
        preshear_untold; ///< there are errors, but none of tau_p: it is one number, and none is stated
    double correlation
        [CLOD_LOCUS_PAIRS]; ///< of the errors of each pair, of one test; NAN: not known
    size_t seed_count;
    size_t preshear_count;  ///< over all seeds (docs/theory/yield-locus.md)
    size_t point_count;     ///< over all seeds
    clod_locus_mark *marks; ///< [point_count] owned
    size_t warning_count;
    char warnings[CLOD_LOCUS_WARNINGS][CLOD_LOCUS_WARNING_TEXT];
} clod_locus;

/**
 * Evaluate the points of one test: one consolidation stress, one seed.
 *
 * @param points  [count] at least two, with different sigma_s
 * @param locus   [out] owned content (clod_locus_fini); what is not right is in its warnings
 * Errors  CLOD_USAGE: a NULL, too few points, one normal stress only, a stress that is no stress.
 * Threads pure.   Source  docs/theory/yield-locus.md; Schulze, Powders and Bulk Solids (2008),
 * ch. 3. Test    tests/analysis/test_locus.c, test_locus_errors.c
 */
bool clod_locus_evaluate(const clod_locus_point *points, size_t count, clod_locus *locus,
                         clod_status *status);

/**
 * Combine the loci of several seeds: mean, scatter (n - 1) and standard error of the mean.
 *
 * @param loci   [count] of clod_locus_evaluate, count >= 1; one is copied as it is
 * @param locus  [out] owned content (clod_locus_fini)
 * Errors  CLOD_USAGE: a NULL, no locus; CLOD_FAILED: memory.   Threads  pure.
 * Test    tests/analysis/test_locus_errors.c
 */
bool clod_locus_combine(const clod_locus *loci, size_t count, clod_locus *locus,
                        clod_status *status);

/** Free the content; an empty locus is fine, NULL is not. */
void clod_locus_fini(clod_locus *self);

/** Jenike's class of a flowability ffc; "undefined" for NAN. Source docs/theory/yield-locus.md.
 */
const char *clod_locus_flow(double ffc);

/** Loci of one consolidation stress. */
typedef struct clod_locus_group {
    clod_locus locus;  ///< over all seeds
    clod_locus *seeds; ///< [seed_count] owned, in ascending order of seed
    size_t seed_count;
} clod_locus_group;

/** All loci of a set of points; several consolidation stresses make a flow function. */
typedef struct clod_locus_study {
    clod_locus_group *groups; ///< [count] owned, in ascending order of sigma_p
    size_t count;
    char warning[CLOD_LOCUS_WARNING_TEXT]; ///< of the flow function; "" = none
} clod_locus_study;

/** What to say beside errors of one specimen, which cannot tell how specimens differ. */
#define CLOD_LOCUS_ONE_SPECIMEN "one specimen: scatter between specimens not included"

/** What more to say where preshears differ and nothing tells whether they are of one specimen, as a ring shear
 *  tester makes them. */
#define CLOD_LOCUS_UNLESS_JENIKE "unless each point has its own, as in a Jenike tester"

/** What to say beside errors with preshear_untold. */
#define CLOD_LOCUS_PRESHEAR_UNTOLD                                                             \
    "error of tau_p not known: not in those of sigma_1, sigma_2, phi_e, ffc"

/** The first of these texts where it is to be said, with the second after a comma where that is; static, or NULL. */
const char *clod_locus_specimen_note(const clod_locus *self);

/** All that the errors leave out, in these texts; static, NULL: nothing. */
const char *clod_locus_errors_note(const clod_locus *self);

/**
 * Sort points into consolidation stresses (preshear stresses more than 2 % apart) and seeds,
 * and evaluate and combine them.
 *
 * @return  owned study (clod_locus_study_destroy), or NULL
 * Errors  as clod_locus_evaluate, naming group and seed.   Threads  pure.
 * Test    tests/analysis/test_study.c
 */
clod_locus_study *clod_locus_study_create(const clod_locus_point *points, size_t count,
                                          clod_status *status);

/** Free and null; NULL is fine. */
void clod_locus_study_destroy(clod_locus_study **self);

/**
 * Preshear for rows of a points file that have none; texts with unit, NULL = none. One that no
 * row needs is refused: the column says otherwise.
 */
typedef struct clod_locus_defaults {
    const char *sigma_pre; ///< for instance "54.8 kPa"
    const char *tau_pre;
} clod_locus_defaults;

/**
 * Read shear points from a CSV file with units in its header.
 *
 * @param path      the file, "-" for standard input: columns sigma_sh, tau_sh and, optional,
 *                  seed, sigma_pre, tau_pre, rho_b, tau_pre_error, tau_sh_error, rho_b_error, rho_inside,
 *                  in any order
 * @param defaults  preshear of rows without; NULL = none
 * @param points    [out] owned (clod_locus_free)
 * @param count     [out]
 * Errors  CLOD_USAGE with file:line, column, value and what to do.   Threads  safe.
 * Test    tests/analysis/test_points.c
 */
bool clod_locus_read(const char *path, const clod_locus_defaults *defaults,
                     clod_locus_point **points, size_t *count, clod_status *status);

/** The same from a text; `path` is the name used in messages. */
bool clod_locus_parse(const char *path, const char *text, size_t length,
                      const clod_locus_defaults *defaults, clod_locus_point **points,
                      size_t *count, clod_status *status);

/** Results for people: aligned tables with units, error bars, warnings; owned, or NULL. */
char *clod_locus_table(const clod_locus_study *study);

/** Everything as JSON, units in the names; owned text (clod_locus_free), or NULL. */
char *clod_locus_json(const clod_locus_study *study);

/** One row per consolidation stress, units in the header; owned text, or NULL. */
char *clod_locus_csv(const clod_locus_study *study);

/** Free points or a text of this header; NULL is fine. */
void clod_locus_free(void *memory);

#ifdef __cplusplus
}
#endif
