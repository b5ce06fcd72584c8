#pragma once
/**
 * @file shear.h
 * What the page of a ring shear or Jenike test shows.
 */

#include <jansson.h>

#include "report/result_table.h"
#include "report/run_files.h"
#include "report/sheet.h"

/** A set of yield loci and whose they are. */
typedef struct clod_shear_loci {
    const char *of;      ///< "simulation", "laboratory", or the name of a run
    const json_t *study; ///< as clod_locus_json has it; borrowed
    bool lab;            ///< points of a laboratory, not of a run
} clod_shear_loci;

/**
 * Evaluate the shear points of a laboratory in a CSV file, as clod locus does.
 *
 * @return     owned study as clod_locus_json has it, or NULL
 * Errors  CLOD_USAGE: as clod_locus_read; CLOD_FAILED: no memory.
 */
json_t *clod_shear_lab(const char *path, clod_status *status);

/**
 * The laboratory's loci for a table beside runs. Where a run tells its bulk density away from the walls of its cell and the
 * laboratory has one density only, that stands beside both of the run: the table cannot know how many grains the laboratory's
 * cell is wide. Of one run its densities say how far that is off.
 *
 * @return  new reference, or NULL: no memory
 * Test  tests/report/test_page.py
 */
json_t *clod_shear_lab_beside(const json_t *lab, const clod_run_files *runs, size_t count);

/** Say below a table with a laboratory's bulk density which one of a run's it is to be compared with. */
void clod_shear_lab_density(clod_writer out, const json_t *lab, const clod_run_files *runs,
                            size_t count);

/** Results, yield loci, curves of a run, with the laboratory's loci laid over (NULL: none).
 *  Errors  CLOD_USAGE: a damaged table. */
bool clod_shear_put(clod_sheet *sheet, const clod_run_files *run, const json_t *lab,
                    clod_status *status);

/**
 * Warn of points of a laboratory at a preshear stress that the run does not have, each text with a 0 at its end; how many.
 * Test  tests/report/test_page.py
 */
size_t clod_shear_lab_warnings(FILE *out, const clod_run_files *run, const json_t *lab);

#define CLOD_SHEAR_MOST 256 ///< yield loci of a table

/** All loci of all sets for a table of results; how many. */
size_t clod_shear_list(const clod_shear_loci *sets, size_t count,
                       clod_result_of of[CLOD_SHEAR_MOST]);

/** Yield loci with Mohr circles, and the flow function. */
void clod_shear_figures(clod_sheet *sheet, const clod_shear_loci *sets, size_t count);

/** Curves over displacement of the parts of a run. Errors  CLOD_USAGE: a damaged table. */
bool clod_shear_curves(clod_sheet *sheet, const clod_run_files *run, clod_status *status);
