#pragma once
/**
 * @file surfaces.h
 * What grains do to each surface of the walls: a measure of free runs (output.surfaces,
 * docs/surfaces.md). The sums are the step's (state/wear.h).
 */

#include "sim/free_measures.h"

extern const clod_free_measure CLOD_MEASURE_SURFACES;
