#pragma once
/**
 * @file energy_series.h
 * The table of the energy ledger: energy.csv, or NAME-energy.csv of a part of a test.
 */

#include "output/series.h"
#include "state/state.h"

#define CLOD_ENERGY_SERIES_COLUMNS 16

/** Header texts. */
extern const char *const clod_energy_series_columns[CLOD_ENERGY_SERIES_COLUMNS];

/** Append the row of this moment, whose energies are `now`. */
bool clod_energy_series_row(clod_series *series, const clod_state *state,
                            const clod_energies *now, clod_status *status);
