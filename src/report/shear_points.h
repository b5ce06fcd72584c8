#pragma once
/**
 * @file shear_points.h
 * Shear points on the page of a shear test: their table, and where on the curves they were read.
 */

#include "report/figure.h"
#include "report/run_files.h"
#include "report/shear.h"

/** Take errors of shear points that the summary of an older clod does not tell from the run's points.csv. */
void clod_shear_points_recall(const clod_run_files *run);

#define CLOD_SHEAR_POINTS_WAY "preshear_displacement_m"
#define CLOD_SHEAR_POINTS_SLOPE "preshear_shear_stress_rate_Pa_per_m"

/**
 * Put into the yield loci of a run how far preshear went and how the shear stress changed at its end, with standard
 * errors: of one preshear those of its own, of several specimens the mean and the error of that. Summaries of older
 * versions of clod have no slope: nothing is put in.
 *
 * Errors  none.   Test  tests/report/test_compare.py
 */
void clod_shear_points_preshear(const clod_run_files *run);

/** The points of all sets, with their errors and whether a peak was found. @param summary  of the run that is
 *  simulated; NULL: none */
void clod_shear_points_put(FILE *out, const json_t *summary, const clod_shear_loci *sets,
                           size_t count);

/** Standard error of the prorated shear stress of a point [Pa]; NaN: not known. */
double clod_shear_points_error(const json_t *point);

/**
 * Mark on the curve of shear stress over displacement of a part what was read there: the peak of a shear point, tau_p of a
 * preshear; hollow where there was no peak or preshear was not steady.
 *
 * @param number  of the curve's colour
 * Test  tests/report/test_shear_page.py
 */
void clod_shear_points_mark(clod_figure *figure, const clod_run_files *run, const char *part,
                            int number);

/** A sentence about these marks, for `figure->note`. */
#define CLOD_SHEAR_POINTS_MARKS                                                                    \
    "Marks: peak of the smoothed curve, or shear stress with which preshear ended, with standard " \
    "errors where known; hollow: no peak was found, or preshear was not steady."
