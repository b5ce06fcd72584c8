#pragma once
/**
 * @file wall_page.h
 * What the page of a wall friction test shows, alone and beside others.
 */

#include <jansson.h>

#include "report/result_table.h"
#include "report/run_files.h"
#include "report/sheet.h"

/** A wall yield locus and whose it is. */
typedef struct clod_wall_page_locus {
    const char *of;      ///< "simulation", "laboratory", or the name of a run
    const json_t *locus; ///< as clod_wall_locus_json has it; borrowed; NULL: there is none yet
    bool lab;            ///< points of a laboratory, not of a run
} clod_wall_page_locus;

/** Results, wall yield locus, angles, curves over displacement of a run, with the laboratory's
 *  locus laid over (NULL: none). Errors  CLOD_USAGE: a damaged table. */
bool clod_wall_page_put(clod_sheet *sheet, const clod_run_files *run, const json_t *lab,
                        clod_status *status);

/** The main results of a locus, one card each. */
void clod_wall_page_cards(FILE *out, const json_t *locus);

#define CLOD_WALL_PAGE_ROW_COUNT 3
extern const clod_result_row CLOD_WALL_PAGE_ROWS[CLOD_WALL_PAGE_ROW_COUNT]; ///< its results

/** Wall yield loci over each other, and their angles over the stress. */
void clod_wall_page_figures(clod_sheet *sheet, const clod_wall_page_locus *loci, size_t count);

/**
 * Evaluate the wall friction table of a laboratory, as clod locus does.
 *
 * @return  owned, as clod_wall_locus_json has it, or NULL
 * Errors  CLOD_USAGE: as clod_wall_locus_read; CLOD_FAILED: no memory.
 * Test    tests/report/test_page.py
 */
json_t *clod_wall_page_lab(const char *path, clod_status *status);
