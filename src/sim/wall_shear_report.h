#pragma once
/**
 * @file wall_shear_report.h
 * From the finished parts of a wall friction test to wall_friction.csv, summary.json and the
 * table.
 */

#include "sim/parts.h"

/**
 * Evaluate and write the results.
 *
 * @param part    [2 * seeds] finished parts, the fillings first
 * @param report  [out] owned text
 */
bool clod_wall_shear_report(const clod_job_shared *sim, const clod_part *part, int seeds,
                            char **report, clod_status *status);

/**
 * When the test failed on its way: write what the finished parts have, wall_friction.csv and
 * summary.json. Nothing when not even a cell was filled.
 *
 * @param part  [2 * seeds] finished or not
 * @param why   goes into the summary
 */
void clod_wall_shear_report_finished(const clod_job_shared *sim, const clod_part *part,
                                     int seeds, const char *why);
