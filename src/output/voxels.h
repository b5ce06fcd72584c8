#pragma once
/**
 * @file voxels.h
 * Cubes of space with numbers, as one VTKHDF file that ParaView opens.
 */

#include "output/folder.h"
#include "output/hdf.h"

/** Cubes, and the columns of their numbers. */
typedef struct clod_voxels {
    const double (*corner)[3]; ///< [count] m, least corner of each; borrowed, as the rest
    size_t count;
    double edge;                    ///< m
    const clod_hdf_column *columns; ///< [column_count] named VTKHDF/CellData/...
    size_t column_count;
    int64_t step; ///< of the run
    double time;  ///< s
} clod_voxels;

/**
 * Write the cubes into a file of the folder; its old content is replaced at one stroke.
 *
 * Errors  CLOD_FAILED: memory, disk, folder.   Threads  one at a time.
 * Test    tests/output/test_snapshot_clumps.c
 */
bool clod_voxels_write(const clod_folder *folder, const char *name, const clod_voxels *self,
                       clod_status *status);
