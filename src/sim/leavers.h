#pragma once
/**
 * @file leavers.h
 * Grains that left through the open sides of a domain that removes them (domain.open: delete):
 * columns of a series, lines of a report, part of a summary.
 */

#include <jansson.h>
#include <stdio.h>

#include "clod/case.h"
#include "state/state.h"

/** Most columns there can be: grains inside, and three for each side. */
#define CLOD_LEAVERS_COLUMNS (1 + 3 * CLOD_FACES)

/**
 * Header texts: none when the domain stops the run, and none of periodic sides.
 *
 * @param names  [out] [CLOD_LEAVERS_COLUMNS] static texts
 * @return       how many
 */
size_t clod_leavers_columns(const clod_case *from, const char **names);

/** The values of these columns now. */
void clod_leavers_row(const clod_case *from, const clod_state *state, double *row);

/** Columns of the series for each outlet. */
#define CLOD_OUTLET_COLUMNS 3

/** Name of a column of outlet k, from 0, into `text`. */
void clod_leavers_outlet_column(const clod_case *from, size_t k, int column, char *text,
                                size_t size);

/** Values of the columns of all outlets; their number. */
size_t clod_leavers_outlets_row(const clod_case *from, const clod_state *state, double *row);

/** The outlets for programs, by name; NULL without any. */
json_t *clod_leavers_outlets_json(const clod_case *from, const clod_state *state);

/** A line for each open side and outlet. */
void clod_leavers_report(FILE *out, const clod_case *from, const clod_state *state);

/** The same, by side; NULL when there is nothing to tell or no memory. */
json_t *clod_leavers_json(const clod_case *from, const clod_state *state);
