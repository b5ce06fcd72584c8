#pragma once
/**
 * @file checkpoint_walls.h
 * The walls of a checkpoint: all that they are, so that walls which a case does not have come
 * back too.
 */

#include "output/hdf.h"
#include "state/walls.h"

/**
 * Write walls with their shapes.
 *
 * Errors  CLOD_FAILED: no memory for a second array of the shapes; `hdf` notes those of the file.
 * Threads  pure.   Test  tests/output/test_checkpoint_walls.c
 */
bool clod_checkpoint_walls_put(clod_hdf *hdf, const clod_walls *walls, clod_status *status);

/**
 * Read walls with their shapes in place of those that are there.
 *
 * @param walls  [in,out] owned by the caller; after a failure none or whole ones
 * @param path   of the file, for messages
 * Errors  CLOD_FAILED: no memory; shapes that do not fit the walls, or of an unknown kind.
 * Threads pure.   Test  tests/output/test_checkpoint_walls.c
 */
bool clod_checkpoint_walls_get(clod_hdf *hdf, clod_walls *walls, const char *path,
                               clod_status *status);
