#pragma once
/**
 * @file free_summary.h
 * What summary.json of a free run has, known before the run.
 */

#include "sim/free_measures.h"

/**
 * Path k of the numbers that the summary of a free run of a case may have.
 *
 * @param path  [out] names with points between; * is any place in a list, ** at its end anything: of
 *              some measures only a run shows what is below their names
 * @return      false: there are no more
 * Errors  none; `residence` is there only when a grain has left.   Threads  pure.
 * Test    tests/calibrate/test_calibrate_paths.py: those of a run
 */
bool clod_free_summary_path(const clod_case *from, size_t k, clod_free_path *path);
