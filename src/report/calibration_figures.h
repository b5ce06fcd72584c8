#pragma once
/**
 * @file calibration_figures.h
 * Figures of a calibration's page: the posterior, what it predicts, and targets over parameters.
 */

#include <jansson.h>
#include <stdbool.h>

#include "report/sheet.h"

/**
 * The posterior of each parameter with its prior, that of each two, and predicted over measured targets.
 *
 * @param result  calibration.json; posterior.csv of the folder has the samples
 * Errors  CLOD_USAGE: a damaged table; CLOD_FAILED: disk, memory.
 * Test  tests/report/test_calibration_page.py
 */
bool clod_calibration_figures_posterior(clod_sheet *sheet, const char *folder,
                                        const json_t *result, clod_status *status);

/** Each target over each parameter (calibration_targets.c). Errors  as above. */
bool clod_calibration_figures_targets(clod_sheet *sheet, const char *folder,
                                      const json_t *result, clod_status *status);
