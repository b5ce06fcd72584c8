#pragma once
/**
 * @file bed.h
 * The grains of a state as a bed: how heavy, how fast, and what presses on it.
 */

#include "clod/case.h"
#include "parallel/exact.h"
#include "state/state.h"

/** Totals of the grains of a state. */
typedef struct clod_setup_bed {
    size_t grains;          ///< so far
    double all;             ///< grains there will be
    double radius_mean;     ///< m, of all
    double radius_sum;      ///< m
    double mass, volume;    ///< kg, m3 of solid
    double speed;           ///< m/s, fastest grain
    double area;            ///< m2, of the grains' bounding box seen along gravity
    double gravity;         ///< m/s2
    double low[3], high[3]; ///< m, around the grains; +-HUGE_VAL: there are none
    clod_exact mass_sum;    ///< kg, the same mass without rounding, as measures have it
    uint64_t last_id;       ///< the largest; 0: there is none
    double above;           ///< m, highest above a plane that it can fall on
} clod_setup_bed;

/** None of so many grains yet, among the walls of a state. */
clod_setup_bed clod_setup_bed_begin(const clod_state *state, size_t grains);

/** Add the grains of the state from `first` on; all of them are added in one order. */
void clod_setup_bed_add(clod_setup_bed *self, const clod_state *state, size_t first);

/** Errors  none.   Threads  pure.   Test  tests/setup/test_setup_state.c */
clod_setup_bed clod_setup_bed_of(const clod_state *state);

/** Area on which a wall presses: its own, or the bed's [m2]. */
double clod_setup_bed_pressed_area(const clod_wall *wall, const clod_setup_bed *bed);

/**
 * Largest stress that weight, or the load of any wall in any stage, puts onto the bed [Pa].
 *
 * Errors  none.   Threads  pure.   Test  tests/setup/test_setup_state.c
 */
double clod_setup_bed_stress(const clod_setup_bed *bed, const clod_case *from,
                             const clod_state *state);

/**
 * Most speed at which grains of a free run may meet [m/s]: of the fastest grain, of a fall
 * through the height of grains and walls, and of the fastest wall, added.
 *
 * Errors  none.   Threads  pure.   Test  tests/setup/test_setup_state.c
 */
double clod_setup_bed_impact(const clod_setup_bed *bed, const clod_state *state);

/** The same of the grains of a state. */
double clod_setup_impact_speed(const clod_state *state);
