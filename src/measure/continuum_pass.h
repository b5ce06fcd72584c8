#pragma once
/**
 * @file continuum_pass.h
 * One pass over all contacts and grains for several fields.
 */

#include "measure/continuum.h"
#include "measure/survey.h"

/** One field of a pass. */
typedef struct clod_continuum_part {
    const clod_continuum *field;
    double (*to)[CLOD_CONTINUUM_SUMS]; ///< [clod_continuum_points] [in,out] a sample is added
} clod_continuum_part;

/**
 * Sample the fields at this moment. In periodic directions grains and branches count with their
 * images: regions lie within the domain there and kernels are no wider than half of it, so each
 * counts once.
 *
 * @param survey  contacts without laws have no stresses
 * Errors  CLOD_FAILED: memory; nothing is added then.   Threads  one per bed.
 * Test    tests/measure/test_continuum.c
 */
bool clod_continuum_pass(const clod_continuum_part *parts, size_t count,
                         const clod_survey *survey, clod_status *status);

extern const clod_survey_way CLOD_CONTINUUM_PASS_WAY;
