#pragma once
/**
 * @file hdf_series.h
 * The `.hdf.series` index with which ParaView opens many files as one film.
 */

#include <jansson.h>
#include <stdint.h>

#include "output/folder.h"

/**
 * Note that `name` shows the moment `time`; entries of the same or later times are dropped.
 *
 * @param index  name of the index in the folder; made when it is not there
 * @param sum    [in,out] checksum of the index, clod_file_crc32; 0: there was none
 * Errors  CLOD_FAILED: not the index that was left, disk full.
 * Test    tests/output/test_snapshot.c
 */
bool clod_hdf_series_add(const clod_folder *folder, const char *index, const char *name,
                         double time, uint64_t *sum, clod_status *status);

/** Whether the files of an index are what clod writes: names without folders, and times. */
bool clod_hdf_series_is_list(const json_t *files);

/** Drop the entries later than `time`, and the files they name; no index is fine. */
bool clod_hdf_series_cut(const clod_folder *folder, const char *index, double time,
                         clod_status *status);

/**
 * Whether an index without its entries later than `time` is the one with this checksum; no
 * index is fine: it was taken away. Nothing is changed.
 */
bool clod_hdf_series_check(const clod_folder *folder, const char *index, double time,
                           uint64_t sum, clod_status *status);
