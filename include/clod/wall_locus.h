#pragma once
/**
 * @file wall_locus.h
 * Evaluation of wall friction tests: points -> wall yield locus, wall friction angles, adhesion.
 * Knows no simulation: points may be simulated or measured. docs/theory/wall-friction.md has the
 * equations and says what the error bars mean. A NULL where an argument is needed: see
 * clod/status.h.
 */

#include "clod/locus.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Steady shear at one wall normal stress. Stresses in Pa; errors: 0 = not stated. */
typedef struct clod_wall_locus_point {
    int64_t seed;       ///< which repeat of the whole test
    double sigma;       ///< wall normal stress sigma_w
    double tau;         ///< steady wall shear stress tau_w
    double sigma_error; ///< standard error of sigma
    double tau_error;   ///< standard error of tau
    double wall_stress; ///< the wall normal stress that was asked for; 0: not stated
    bool unsteady;      ///< the shear stress still changed where tau was taken
    bool of_angle; ///< tau is that of an angle phi_x, which was measured or told in its place
} clod_wall_locus_point;

/** A point with what follows from it. */
typedef struct clod_wall_locus_mark {
    clod_wall_locus_point point;
    clod_locus_value phi_x; ///< angle of the line from the origin to the point [rad]
    double line;            ///< the fitted line at sigma [Pa]
} clod_wall_locus_mark;

#define CLOD_WALL_LOCUS_WARNINGS 8

/** A wall yield locus tau_w = tau_ad + sigma_w tan(phi_w), fitted to the points. */
typedef struct clod_wall_locus {
    clod_locus_value phi_w;  ///< kinematic angle of wall friction of the line [rad]
    clod_locus_value tau_ad; ///< wall adhesion: the line at sigma_w = 0 [Pa]
    double r_squared;        ///< of the line; the smallest of the seeds
    clod_locus_errors errors;
    size_t seed_count;
    size_t point_count;          ///< over all seeds
    clod_wall_locus_mark *marks; ///< [point_count] owned, by seed, in descending order of sigma
    size_t warning_count;
    char warnings[CLOD_WALL_LOCUS_WARNINGS][CLOD_LOCUS_WARNING_TEXT];
} clod_wall_locus;

/**
 * Evaluate the points of one or more tests of the same wall: a line through those of each seed;
 * of several seeds the mean of their lines, with its standard error from their scatter.
 *
 * @param points  [count] two of each seed at least, with different sigma
 * @param locus   [out] owned content (clod_wall_locus_fini); what is not right is in its warnings
 * Errors  CLOD_USAGE: a NULL, too few points, one normal stress only, a stress that is none.
 * Threads pure.   Source  docs/theory/wall-friction.md; Schulze, Powders and Bulk Solids (2008),
 * ch. 3.3.   Test  tests/analysis/test_wall_locus.c
 */
bool clod_wall_locus_evaluate(const clod_wall_locus_point *points, size_t count,
                              clod_wall_locus *locus, clod_status *status);

/**
 * The same of points from a table, of which a line that falls is refused: no wall has one. Where all points have a
 * wall_stress they are of a simulation, and it is a warning.
 *
 * Errors  CLOD_USAGE: as clod_wall_locus_evaluate, and phi_w below 0.   Threads pure.
 * Test    tests/analysis/test_wall_locus.c
 */
bool clod_wall_locus_of_table(const clod_wall_locus_point *points, size_t count,
                              clod_wall_locus *locus, clod_status *status);

/** Free the content; an empty locus is fine, NULL is not. */
void clod_wall_locus_fini(clod_wall_locus *self);

/** Whether the errors are those of one specimen, which cannot tell how specimens differ. */
bool clod_wall_locus_one_specimen(const clod_wall_locus *self);

/**
 * Read a wall yield locus from a CSV file with units in its header.
 *
 * @param path    the file, "-" for standard input: columns sigma_w, tau_w and, optional, seed,
 *                sigma_w_error, tau_w_error, wall_stress (that was asked for: the points are of a
 *                simulation, where all have it), steady (1 or 0), in any order; what
 *                clod writes beside is skipped
 * @param points  [out] owned (clod_locus_free)
 * @param count   [out]
 * Errors  CLOD_USAGE with file:line, column, value and what to do.   Threads  safe.
 * Test    tests/analysis/test_wall_points.c
 */
bool clod_wall_locus_read(const char *path, clod_wall_locus_point **points, size_t *count,
                          clod_status *status);

/** The same from a text; `path` is the name used in messages. */
bool clod_wall_locus_parse(const char *path, const char *text, size_t length,
                           clod_wall_locus_point **points, size_t *count, clod_status *status);

/** Results for people: an aligned table with units, error bars, warnings; owned
 *  (clod_locus_free), or NULL. */
char *clod_wall_locus_table(const clod_wall_locus *self);

/** Everything as JSON, units in the names; owned text (clod_locus_free), or NULL. */
char *clod_wall_locus_json(const clod_wall_locus *self);

/** One row per point, units in the header, which clod_wall_locus_read reads; owned text, or
 *  NULL. */
char *clod_wall_locus_csv(const clod_wall_locus *self);

#ifdef __cplusplus
}
#endif
