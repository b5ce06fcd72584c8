#pragma once
/**
 * @file ring_measure.h
 * What is read off a ring shear cell: its measures, and one row of the test's series.
 */

#include "tester/ring_shear.h"

/** Height of the lid's plane above the base [m]. */
double clod_ring_lid_height(const clod_ring_shear *self, const clod_state *state);

/** Stress of the solid that is above the shear plane, the tips of the lid's bars [Pa]. */
double clod_ring_solid_above(const clod_ring_shear *self, const clod_state *state);

/** Speed with which the trough shears the solid now, at r_m [m/s]. */
double clod_ring_speed(const clod_ring_shear *self, const clod_state *state);

/** Volume of the bars of trough and lid [m3]. */
double clod_ring_bars_volume(const clod_state *state);

/** Mean of what the walls felt since the last look: row [CLOD_RING_SHEAR_COLUMNS]. */
void clod_ring_measure(const clod_ring_shear *self, const clod_state *state, double *row);
