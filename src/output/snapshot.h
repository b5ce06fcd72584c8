#pragma once
/**
 * @file snapshot.h
 * Pictures of the state for ParaView: VTKHDF 1.0 files and their `.hdf.series` index.
 *
 * Layout: https://docs.vtk.org, "VTKHDF file format", version 1.0, UnstructuredGrid. Numbers
 * are float32, positions included. The names of the files and arrays are in
 * docs/howto/paraview.md.
 */

#include "clod/status.h"
#include "state/state.h"

/**
 * Write grains and walls, and contacts when asked, and put them into their series.
 *
 * The series keeps only entries of earlier times, so a resumed run leaves the index of an
 * uninterrupted one.
 *
 * @param directory  folder, must exist
 * @param stem       name of the series; "run" is left out of the names of the single files
 * @param number     number in the names of the files
 * @param contacts   also write the grain-grain contacts of state->contacts
 * Errors  CLOD_FAILED: no folder, disk full, no memory, an index that is not ours.
 * Threads one per stem.   Test  tests/output/test_snapshot.c
 */
bool clod_snapshot_write(const char *directory, const char *stem, int64_t number,
                         const clod_state *state, bool contacts, clod_status *status);

/** Drop from the series, and remove, the snapshots later than `time` [s]; none is fine. */
bool clod_snapshot_resume(const char *directory, const char *stem, double time,
                          clod_status *status);
