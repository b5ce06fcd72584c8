#pragma once
/**
 * @file wall_loads.h
 * Force, torque, power and position of each wall: a measure of free runs.
 */

#include "sim/free_measures.h"

extern const clod_free_measure CLOD_MEASURE_WALL_LOADS;
