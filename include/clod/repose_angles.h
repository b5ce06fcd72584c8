#pragma once
/**
 * @file repose_angles.h
 * Angles of repose as a laboratory measured them, one of each heap, and their mean. A NULL where an
 * argument is needed: see clod/status.h.
 */

#include "clod/locus.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What an angle of repose may be, from the first on and below the second [deg]: glass beads that roll freely make some
 *  20, so below 5 the unit is rad. */
#define CLOD_REPOSE_ANGLES_LEAST 5.0
#define CLOD_REPOSE_ANGLES_MOST 90.0

/** Angle of repose of one heap. */
typedef struct clod_repose_heap {
    double angle; ///< rad
    double error; ///< standard error [rad]; 0 = not stated
} clod_repose_heap;

/** Heaps of one solid. */
typedef struct clod_repose_angles {
    clod_locus_value mean; ///< rad; scatter: standard deviation of the heaps
    size_t heap_count;
    clod_repose_heap *heaps;               ///< [heap_count] owned, in the order given
    char warning[CLOD_LOCUS_WARNING_TEXT]; ///< what is not right; "": nothing
} clod_repose_angles;

/**
 * Mean of the angles, all with the same weight. Its standard error is the larger of what their scatter and
 * what the stated errors make; the stated ones count where every heap has one. NAN where neither is known: of
 * one heap, or of heaps with one and the same (rounded) angle, that state none.
 *
 * @param heaps  [count] one at least
 * @param self   [out] owned content (clod_repose_angles_fini)
 * Errors  CLOD_USAGE: a NULL, no heap; CLOD_FAILED: memory.   Threads  pure.
 * Source  JCGM 100:2008 (GUM), 4.2.3 and 5.1.2   Test  tests/analysis/test_repose_angles.c
 */
bool clod_repose_angles_evaluate(const clod_repose_heap *heaps, size_t count,
                                 clod_repose_angles *self, clod_status *status);

/** Free the content; an empty one is fine, NULL is not. */
void clod_repose_angles_fini(clod_repose_angles *self);

/**
 * Read a table from the text of a CSV file with units in its header: one row per heap, angles of 5 to 90 deg.
 *
 * @param path   name used in messages
 * @param text   [length] columns angle_of_repose and, optional, angle_of_repose_error; seed and heap, numbers of
 *               the heaps, are skipped
 * @param heaps  [out] owned (clod_locus_free)
 * Errors  CLOD_USAGE with file:line, column, value and what to do.   Threads  safe.
 * Test    tests/analysis/test_repose_angles.c
 */
bool clod_repose_angles_parse(const char *path, const char *text, size_t length,
                              clod_repose_heap **heaps, size_t *count, clod_status *status);

/** A table for people, everything as JSON, one row per heap as CSV; owned (clod_locus_free), or NULL. */
char *clod_repose_angles_table(const clod_repose_angles *self);
char *clod_repose_angles_json(const clod_repose_angles *self);
char *clod_repose_angles_csv(const clod_repose_angles *self);

#ifdef __cplusplus
}
#endif
