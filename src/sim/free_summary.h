#pragma once
/**
 * @file free_summary.h
 * What summary.json of a free run has, known before the run.
 */

#include "sim/free_measures.h"

/**
 * Paths of the numbers that the summary of a free run of a case may have: all of them, and no others.
 *
 * @param paths  [out] owned by the caller (clod_free_paths_fini), also after a failure. What a run only
 *               may have is among them: `residence` and impact angles, which need grains that left and
 *               that hit, and classes of lists, of which a run tells those that it met
 * Errors  CLOD_USAGE: a mesh of a wall cannot be read, with its key; CLOD_FAILED: memory.
 * Threads safe.
 * Test    tests/calibrate/test_calibrate_paths.py: those of a run
 */
bool clod_free_summary_paths(const clod_case *from, clod_free_paths *paths,
                             clod_status *status);
