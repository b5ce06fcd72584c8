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
 */
bool clod_ring_report(const clod_sim *sim, const clod_part *part, int preparations, int points,
                      char **report, clod_status *status);
