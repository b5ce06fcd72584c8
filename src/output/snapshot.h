#pragma once
/**
 * @file snapshot.h
 * Pictures of the state for ParaView: VTKHDF 1.0 files and their `.hdf.series` index.
 *
 * Layout: https://docs.vtk.org, "VTKHDF file format", version 1.0, UnstructuredGrid. Numbers
 * are float32, positions included. The names of the files and arrays are in
 * docs/howto/paraview.md.
 */

#include <stdint.h>

#include "output/folder.h"
#include "state/bed_source.h"
#include "state/state.h"

/** Checksums of the series of grains, walls and contacts, as last written; 0: none was. */
typedef struct clod_snapshot_film {
    uint64_t crc32[3];
} clod_snapshot_film;

/**
 * Write grains and walls, and contacts when asked, and put them into their series; and the state
 * file of ParaView that shows them (paraview.h).
 *
 * The series keeps only entries of earlier times, so a resumed run leaves the index of an
 * uninterrupted one.
 *
 * @param stem       name of the series; "run" is left out of the names of the single files
 * @param number     number in the names of the files
 * @param bed        its grains and contacts; NULL: those of the state itself
 * @param contacts   also write the grain-grain contacts, which are in the state
 * @param film       [in,out] checksums of the series
 * Errors  CLOD_FAILED: no folder, disk full, no memory, an index that is not ours.
 * Threads one per stem.   Test  tests/output/test_snapshot.c
 */
bool clod_snapshot_write(const clod_folder *folder, const char *stem, int64_t number,
                         const clod_state *state, const clod_bed_source *bed, bool contacts,
                         clod_snapshot_film *film, clod_status *status);

/** Drop from the series, and remove, the snapshots later than `time` [s]; none is fine. */
bool clod_snapshot_resume(const clod_folder *folder, const char *stem, double time,
                          clod_status *status);

/** Whether the series up to `time` are those of the film, or not there; nothing is changed. */
bool clod_snapshot_check(const clod_folder *folder, const char *stem, double time,
                         const clod_snapshot_film *film, clod_status *status);
