#pragma once
/**
 * @file cards.h
 * The few numbers that matter most, large, at the head of a page.
 */

#include "report/result_table.h"
#include "report/run_files.h"
#include "report/sheet.h"

// Those of a run, by its kind.
void clod_cards_shear(FILE *out, const clod_run_files *run);
void clod_cards_uniaxial(FILE *out, const clod_run_files *run);
void clod_cards_wall(FILE *out, const clod_run_files *run);
void clod_cards_free(FILE *out, const clod_run_files *run);

/** A card of a result with its error. @param more  text behind what it is; NULL: none */
void clod_cards_result(FILE *out, const json_t *from, const clod_result_row *row,
                       const char *more);

/** Write the cards of a run; nothing when it has no results yet. */
void clod_cards_put(FILE *out, const clod_run_files *run);
