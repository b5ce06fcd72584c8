#pragma once
/**
 * @file facets.h
 * Triangle meshes of round walls and of bars, as STL files beside a case.
 */

#include <stdio.h>

#include "base/vec3.h"
#include "clod/status.h"

/** A mesh that is being written. */
typedef struct clod_verify_facets {
    char path[4096];
    FILE *out;
} clod_verify_facets;

/**
 * Begin FOLDER/NAME.stl.
 *
 * Errors  CLOD_FAILED: it cannot be written.   Threads  one per file.
 */
bool clod_verify_facets_open(clod_verify_facets *self, const char *folder, const char *name,
                             clod_status *status);

/**
 * The surface that a line through points (r, z) makes as it turns about the z axis: a polygon of
 * `sides` whose mean distance from the axis is r.
 *
 * @param points  [count] r and z [m], 0 < r
 * Threads  one per file.   Test  tests/verify/test_facets.c
 */
void clod_verify_facets_lathe(clod_verify_facets *self, const double (*points)[2], int count,
                              int sides);

/** A solid box: its centre, and half of its edges [m], as vectors. Test: test_facets.c */
void clod_verify_facets_box(clod_verify_facets *self, clod_vec3 center,
                            const clod_vec3 half[3]);

/** End the file. Errors: CLOD_FAILED: it could not be written. */
bool clod_verify_facets_close(clod_verify_facets *self, clod_status *status);
