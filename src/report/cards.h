#pragma once
/**
 * @file cards.h
 * The few numbers that matter most, large, at the head of a page.
 */

#include "report/run_files.h"
#include "report/sheet.h"

/** Write the cards of a run; nothing when it has no results yet. */
void clod_cards_put(FILE *out, const clod_run_files *run);
