#pragma once
/**
 * @file study_file.h
 * The yield loci of a table, whose name stands before what an evaluation says of its points.
 *
 * Threads  pure.   Errors  as clod_locus_read and clod_locus_study_create.
 * Test     tests/analysis/test_study.c
 */

#include "clod/locus.h"

/** Of measured points that come from a file of this name, angles checked (angles.h); NULL with
 *  status. */
clod_locus_study *clod_study_of_points(const char *path, const clod_locus_point *points,
                                       size_t count, clod_status *status);

/** Of a file of measured points, angles checked; NULL with status. */
clod_locus_study *clod_study_of_file(const char *path, clod_status *status);

/** Of the file of points that a run wrote, whatever its angles are; NULL with status. */
clod_locus_study *clod_study_of_run(const char *path, clod_status *status);
