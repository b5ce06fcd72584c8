#pragma once
/**
 * @file leavers_table.h
 * leavers.csv: one row for each grain that leaves a free run (output.leavers).
 */

#include "clod/case.h"
#include "output/series.h"
#include "state/state.h"

#define CLOD_LEAVERS_TABLE "leavers.csv"
#define CLOD_LEAVERS_TABLE_COLUMNS 7

/** Header texts. */
extern const char *const CLOD_LEAVERS_TABLE_COLUMN[CLOD_LEAVERS_TABLE_COLUMNS];

/**
 * Append what state->gone has, by time and id, and empty it.
 *
 * Errors  CLOD_FAILED: memory, disk.   Threads  one per state.
 * Test    tests/cli/test_residence.py
 */
bool clod_leavers_table_write(clod_series *series, const clod_case *from, clod_state *state,
                              clod_status *status);
