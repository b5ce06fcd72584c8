#pragma once
/**
 * @file free_summary.h
 * What summary.json of a free run has at its top, known before the run.
 */

#include "sim/free_measures.h"

#define CLOD_FREE_SUMMARY_OWN 11 ///< numbers of the run itself, and the list of its stages
#define CLOD_FREE_SUMMARY_MOST (CLOD_FREE_SUMMARY_OWN + CLOD_FREE_MEASURES_MOST)

/**
 * Names at the top of the summary of a free run of a case, below which there are numbers.
 *
 * @param names  [out] [CLOD_FREE_SUMMARY_MOST] borrowed
 * @return       their number
 * Errors  none; `residence` is there only when a grain has left.   Threads  pure.
 * Test    tests/calibrate/test_calibrate_paths.py: those of a run
 */
size_t clod_free_summary_names(const clod_case *from,
                               const char *names[CLOD_FREE_SUMMARY_MOST]);
