#pragma once
/**
 * @file gauge_pass.h
 * One pass over all grains for several gauges: each grain is added to those whose region holds
 * its centre.
 */

#include "measure/gauge_bins.h"
#include "measure/survey.h"

/** One gauge of a pass. */
typedef struct clod_gauge_part {
    clod_gauge gauge;
    double *sums;                          ///< [CLOD_GAUGE_SUMS] [out] of this sample
    clod_gauge_bins *profile, *trajectory; ///< [in,out] a sample is added; NULL: none
    clod_gauge_axis across, along;         ///< of these
} clod_gauge_part;

/**
 * Sample the grains for all gauges. Sums are exact: they do not depend on the order of rows.
 *
 * @param parts  [count] regions may overlap; of alarm and work the sums are none
 * Errors  CLOD_FAILED: memory; nothing is added to the bins then.   Threads  one per bed.
 * Test    tests/measure/test_gauge.c
 */
bool clod_gauge_pass(const clod_gauge_part *parts, size_t count, const clod_survey *survey,
                     clod_status *status);

extern const clod_survey_way CLOD_GAUGE_PASS_WAY;
