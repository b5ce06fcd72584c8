#pragma once
/**
 * @file history_map.h
 * What grain-grain contacts remember, by cells of space: a measure of free runs
 * (docs/clumps.md). It is taken at every row of the series, and leaves history_map.hdf.
 */

#include "sim/free_measures.h"

extern const clod_free_measure CLOD_MEASURE_HISTORY_MAP;
