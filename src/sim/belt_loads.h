#pragma once
/**
 * @file belt_loads.h
 * Speed of each belt, and the pull that the load adds to its tension: a measure of free runs.
 *
 * Told of walls of which nothing moves but the belts of their shapes, all with one speed: then
 * the wall's power is force along the belt times speed, wherever on it the force acts.
 */

#include "sim/free_measures.h"

extern const clod_free_measure CLOD_MEASURE_BELT_LOADS;
