#pragma once
/**
 * @file run_pages.h
 * What the pages of uniaxial tests and free runs show beside what every page has. No laboratory's results
 * are laid over them: `lab` is NULL.
 */

#include <jansson.h>

#include "report/run_files.h"
#include "report/sheet.h"

/** Strengths, flow function, stress and height over strain. Errors  CLOD_USAGE: a damaged table. */
bool clod_run_pages_uniaxial(clod_sheet *sheet, const clod_run_files *run, const json_t *lab,
                             clod_status *status);

/** Series, books of grains, gauges, surfaces, clumps. Errors  CLOD_USAGE: a damaged table. */
bool clod_run_pages_free(clod_sheet *sheet, const clod_run_files *run, const json_t *lab,
                         clod_status *status);
