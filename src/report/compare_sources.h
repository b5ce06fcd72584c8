#pragma once
/**
 * @file compare_sources.h
 * Where the results of compared runs come from.
 */

#include <stdio.h>

#include "report/run_files.h"

/** Folder, version, time, seed and cost of each run.   Test  tests/report/test_compare.py */
void clod_compare_sources_put(FILE *out, const clod_run_files *runs, size_t count);
