#pragma once
/**
 * @file bed.h
 * What the procedures of all testers see of a bed and do with its lid: the operator's hand.
 * None of the constants is physics; docs/theory/ring-shear.md says why they are what they are.
 */

#include "state/state.h"

/** A wall by name; NULL for a name that is not there. */
clod_wall *clod_bed_wall(const clod_state *state, const char *name);

/** Mass of all grains [kg]. */
double clod_bed_mass(const clod_state *state);

/** Largest radius of the grains [m]. */
double clod_bed_largest(const clod_state *state);

/** Volume of all bars on walls [m3]. */
double clod_bed_bars_volume(const clod_state *state);

/** Root mean square of the grains' speeds [m/s]. */
double clod_bed_rms_speed(const clod_state *state);

/** Highest point of the grains [m]. */
double clod_bed_top(const clod_state *state);

/** Time in which a grain that nothing holds gets this fast [s]; endless without gravity. */
double clod_bed_fall_time(const clod_state *state, double speed);

/**
 * Whether filling is over: the grains rest, or its time is.
 *
 * @param in_phase  since filling began [s]
 * @param most      time that filling may take [s]
 * @param late      [out] its time is over
 */
bool clod_bed_is_filled(const clod_state *state, double in_phase, double most, bool *late);

/**
 * Put the wall "lid" down to just above the settled grains and let it come down; the neighbour
 * search starts anew.
 *
 * @param height  of the lid's plane now [m]
 * @param bars    how far its bars hang below the plane [m]
 */
void clod_bed_put_lid(clod_state *state, double height, double bars);

/** The lid carries: its servo takes over at the speed at which it came down. */
void clod_bed_take_over(clod_wall *lid);

/** How much of a change of load is done, 0 to 1, along the ramp. */
double clod_bed_ramp(double in_phase);

/**
 * Whether the lid has been at rest under its load for long enough.
 *
 * @param calm    [in,out] looks in a row in which it was
 * @param speed   of the lid, mean since the last look [m/s]
 * @param stress  mean normal stress since the last look, as a fraction of the one aimed at
 */
bool clod_bed_is_calm(int64_t *calm, double speed, double stress);
