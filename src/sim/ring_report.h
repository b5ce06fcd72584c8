#pragma once
/**
 * @file ring_report.h
 * From the finished parts of a shear test to points.csv, summary.json and the table.
 */

#include "sim/ring_run.h"

/**
 * Evaluate and write the results.
 *
 * @param part          [preparations + points] finished parts, preparations first
 * @param report        [out] owned text
 * Errors  CLOD_FAILED: the points give no yield locus; disk, memory.
 * Test    tests/sim/test_reports.c
 */
bool clod_ring_report(const clod_job_shared *sim, const clod_part *part, int preparations,
                      int points, char **report, clod_status *status);

/**
 * When the test failed on its way, or its points give no yield locus: write what the finished
 * parts have, points.csv and a summary.json without locus. Nothing when no part is finished.
 *
 * @param part  [preparations + points] finished or not
 * @param why   goes into the summary
 */
void clod_ring_report_finished(const clod_job_shared *sim, const clod_part *part,
                               int preparations, int points, const char *why);
