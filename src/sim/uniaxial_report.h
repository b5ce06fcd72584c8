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
bool clod_uniaxial_report(const clod_sim *sim, const clod_part *part, int points, char **report,
                          clod_status *status);
