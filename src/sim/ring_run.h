#pragma once
/**
 * @file ring_run.h
 * A whole ring shear test: for every seed the presheared specimen, then all shear points from
 * it, side by side where cores allow; then the yield locus.
 */

#include "sim/job.h"
#include "tester/ring_shear.h"

/** One finished part of the test: the preparation of a seed, or a point. */
typedef struct clod_ring_part {
    char name[48];
    int64_t seed;
    int64_t point; ///< row of shear_stresses; -1 for the preparation
    clod_ring_shear test;
    int64_t steps;                  ///< of this part
    double dt;                      ///< s
    double wall_clock;              ///< s
    char version[CLOD_JOB_VERSION]; ///< of the clod that began this part
    size_t grains;
    double coordination;              ///< grain-grain contacts of a grain at the end
    double max_overlap, mean_overlap; ///< fraction of a radius, at the end
    bool ok;
    clod_status status;
} clod_ring_part;

/** Run the test; the report is the result table with the warning box. */
bool clod_ring_run(const clod_sim *sim, char **report, clod_status *status);
