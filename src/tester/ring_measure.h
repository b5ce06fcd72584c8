#pragma once
/**
 * @file ring_measure.h
 * What of the procedure depends on the cell of a ring shear tester: how it is driven, its
 * measures, and one row of the test's series.
 */

#include "tester/ring_shear.h"

/** Height of the lid's plane above the base [m]. */
double clod_ring_lid_height(const clod_ring_shear *self, const clod_state *state);

/** Stress of the solid above the shear plane, in a ring the tips of the lid's bars [Pa]. */
double clod_ring_solid_above(const clod_ring_shear *self, const clod_state *state);

/** Speed with which the trough shears the solid now, at r_m [m/s]. */
double clod_ring_speed(const clod_ring_shear *self, const clod_state *state);

/** Turn trough and sides so that the solid is sheared with `speed` at r_m [m/s]. */
void clod_ring_set_speed(const clod_ring_shear *self, clod_state *state, double speed);

/** Whether the speed is the procedure's target, to the last bit. */
bool clod_ring_is_at_speed(const clod_ring_shear *self, const clod_state *state);

/** Volume of the bars of trough and lid [m3]. */
double clod_ring_bars_volume(const clod_state *state);

/** Mean of what the walls felt since the last look: row [CLOD_RING_SHEAR_COLUMNS]. */
void clod_ring_measure(const clod_ring_shear *self, const clod_state *state, double *row);
