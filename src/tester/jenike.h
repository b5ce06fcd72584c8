#pragma once
/**
 * @file jenike.h
 * What of a shear test's procedure (tester/ring_shear.h) depends on the Jenike cell: how it is
 * driven, and what is read off it. Shear ring and lid move along x as one, base and base ring
 * stand still (setup/jenike_cell.h; docs/theory/jenike.md).
 */

#include "tester/ring_shear.h"

/** Begin with the filling of a fresh cell. */
void clod_jenike_begin(clod_ring_shear *self, const clod_case *from, clod_state *state);

/** Move shear ring and lid along x [m/s]. */
void clod_jenike_set_speed(clod_state *state, double speed);

/** Speed of the shear ring along x [m/s]. */
double clod_jenike_speed(const clod_state *state);

/** Whether the speed is the procedure's target, to the last bit. */
bool clod_jenike_is_at_speed(const clod_ring_shear *self, const clod_state *state);

/** Whether the shear ring is as far behind the base ring as its rim is thick, or farther. */
bool clod_jenike_is_behind(const clod_state *state);

/**
 * Twist the lid to one side and to the other, `twists` times, its edge moving with `speed`.
 *
 * @param change  of the edge's speed since the last look, at most [m/s]
 * @return        true when all is done and the lid stands
 * Errors  none.   Source  ASTM D6128.   Test  tests/tester/test_jenike.c
 */
bool clod_jenike_twist(clod_ring_shear *self, clod_state *state, double change);

/**
 * Mean of what the walls felt since the last look: row [CLOD_RING_SHEAR_COLUMNS].
 *
 *     tau        = -F_x(shear ring and lid)/A     tau_base   = F_x(base and base ring)/A
 *     sigma      =  F_z(lid)/A + solid above      sigma_base = -F_z(base and base ring)/A
 *
 * with the forces of the grains on the walls, A the inner area and the shear plane between the
 * rings.
 */
void clod_jenike_measure(const clod_ring_shear *self, const clod_state *state, double *row);
