#pragma once
/**
 * @file lattice.h
 * The largest stable time step of the simplest bed, in closed form: what `clod check` estimates a bed
 * with that nobody has sheared yet.
 */

#include "law/law.h"

/**
 * Largest stable step of a periodic cubic lattice of equal grains whose six contacts are all alike: on
 * the stiffest branch, none slides or rolls at its limit. The smallest of three modes: neighbours
 * against each other, 4 k + 8 k_t by m; all turning alike, 8 k_t a^2 by I; neighbours turning against
 * each other, 8 k_r by I; each with the dash-pots of the same contacts.
 *
 * @param law      of two grains
 * @param mass     of a grain [kg]
 * @param radius   [m]
 * @param overlap  of every contact [m], > 0
 * @return         s
 * Errors  none.   Threads  pure.
 * Source  docs/theory/stability.md.   Test  tests/setup/test_setup_lattice.c
 */
double clod_lattice_step(const clod_law *law, double mass, double radius, double overlap);
