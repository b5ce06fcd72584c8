#pragma once
/**
 * @file leavers.h
 * Grains that left through the open sides of a domain that removes them (domain.open: delete)
 * and through outlets: measures of free runs.
 */

#include "sim/free_measures.h"

/** Grains inside; number, mass and energy of those that left, by side of the domain. */
extern const clod_free_measure CLOD_MEASURE_LEAVERS;

/** The same of each outlet. */
extern const clod_free_measure CLOD_MEASURE_OUTLETS;
