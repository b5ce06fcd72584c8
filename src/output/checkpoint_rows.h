#pragma once
/**
 * @file checkpoint_rows.h
 * Rows of grains and contacts in a checkpoint, written at their places past HDF5: so whoever has them can
 * write them, in any order.
 *
 * Threads  one per file.   Test  tests/output/test_checkpoint_stream.c, tests/step/test_ranks_slabs.c
 */

#include "base/bytes.h"
#include "output/checkpoint_columns.h"
#include "output/folder_files.h"
#include "output/hdf.h"
#include "state/bed_source.h"

/** Have room for the columns of a bed, and note where. The bed has begun. */
bool clod_checkpoint_rows_reserve(clod_hdf *hdf, const clod_state *state,
                                  const clod_bed_source *bed, clod_bed_layout *layout,
                                  clod_status *status);

/**
 * Write the rows of some columns at their places, as row `first` and the following.
 *
 * @param place   [columns->count] first byte of each column in the file
 * @param packed  [in,out] scratch
 * @return        0 or an errno value
 */
int clod_checkpoint_rows_put(int descriptor, const clod_checkpoint_columns *columns,
                             const uint64_t *place, size_t first, clod_bytes *packed);

/** Write all grains and contacts of a bed that has begun, by all who have them, or here, slab by slab. */
bool clod_checkpoint_rows_write(const clod_folder_draft *draft, const clod_bed_source *bed,
                                clod_bed_layout *layout, clod_status *status);
