#pragma once
/**
 * @file hdf_series.h
 * The `.hdf.series` index with which ParaView opens many files as one film.
 */

#include "clod/status.h"

/**
 * Note that `name` shows the moment `time`; entries of the same or later times are dropped.
 * @param path  the index, next to the files; made when it is not there
 * Errors  CLOD_FAILED: not an index of clod, disk full.   Test  tests/output/test_snapshot.c
 */
bool clod_hdf_series_add(const char *path, const char *name, double time, clod_status *status);

/** Drop the entries later than `time`, and the files they name; no index is fine. */
bool clod_hdf_series_cut(const char *path, double time, clod_status *status);
