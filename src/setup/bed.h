#pragma once
/**
 * @file bed.h
 * The grains of a state as a bed: how heavy, how fast, and what presses on it.
 */

#include "clod/case.h"
#include "state/state.h"

/** Totals of the grains of a state. */
typedef struct clod_setup_bed {
    double radius_mean;  ///< m
    double mass, volume; ///< kg, m3 of solid
    double speed;        ///< m/s, fastest grain
    double area;         ///< m2, of the grains' bounding box seen along gravity
    double gravity;      ///< m/s2
} clod_setup_bed;

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
double clod_setup_impact_speed(const clod_state *state);
