#pragma once
/**
 * @file compare_figures.h
 * Figures of a comparison, by the kind of its runs; those of wall friction tests are in wall_compare.h.
 */

#include <jansson.h>

#include "report/run_files.h"
#include "report/sheet.h"

/** Yield loci over each other, the curves of preshear and of each shear to failure, and slices of fields.
 *  Errors  CLOD_USAGE: a damaged table; CLOD_FAILED: no memory. */
bool clod_compare_figures_shear(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                                const json_t *lab, clod_status *status);

/** Flow functions, axial stresses over strain, and slices of fields. Errors  as above. */
bool clod_compare_figures_uniaxial(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                                   const json_t *lab, clod_status *status);

/** The columns that matter most and that all have, and slices of fields. Errors  as above. */
bool clod_compare_figures_free(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status);
