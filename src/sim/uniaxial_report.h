#pragma once
/**
 * @file uniaxial_report.h
 * From the finished parts of a uniaxial test to flow_function.csv, summary.json and the table.
 */

#include "sim/parts.h"

/**
 * Evaluate and write the results.
 *
 * @param part    [1 + points] finished parts, the filling first
 * @param report  [out] owned text
 */
bool clod_uniaxial_report(const clod_job_shared *sim, const clod_part *part, int points,
                          char **report, clod_status *status);

/**
 * When the test failed on its way: write what the finished parts have, flow_function.csv and
 * summary.json. Nothing when not even the mould was filled.
 *
 * @param part  [1 + points] finished or not
 * @param why   goes into the summary
 */
void clod_uniaxial_report_finished(const clod_job_shared *sim, const clod_part *part,
                                   int points, const char *why);
