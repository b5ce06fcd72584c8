#pragma once
/**
 * @file impacts.h
 * How grains hit a surface: numbers and energies of impacts by classes of angle and normal
 * energy. So grains that rattle on a surface are apart from those that hit it.
 *
 * All members are doubles: the table lies behind the sums of places in clod_wall.wear, and is
 * kept, copied and written with them (wear.h). Numbers are exact up to 2^53.
 *
 * Source  docs/theory/wear.md.   Test  tests/state/test_impacts.c
 */

#include <stdint.h>

/** Classes of 10 degrees. */
#define CLOD_IMPACT_ANGLES 9

/** Classes of normal energy: below the first bound, between bounds, from the last bound on. */
#define CLOD_IMPACT_BOUNDS 55
#define CLOD_IMPACT_ENERGIES (CLOD_IMPACT_BOUNDS + 1)

/** One impact. */
typedef struct clod_impact {
    double angle;  ///< rad, between the way of the centre and the surface, 0 to pi/2
    double speed;  ///< m/s, of the centre against the material of the surface
    double energy; ///< J, m v^2/2 with that speed
    double normal; ///< J, the part of it that goes into the surface, m v_n^2/2
} clod_impact;

/** Impacts of one class. */
typedef struct clod_impact_class {
    double number;
    double energy; ///< J
    double normal; ///< J, of it
} clod_impact_class;

/** Sums over impacts. */
typedef struct clod_impact_sums {
    double number;
    double angle, angle2;   ///< rad, rad2: of angles and of their squares
    double speed, speed2;   ///< m/s, m2/s2
    double normal, normal2; ///< J, J2
    double energy;          ///< J
} clod_impact_sums;

/** Impacts of a surface. All zero: none yet. */
typedef struct clod_impacts {
    clod_impact_sums all;
    clod_impact_sums row; ///< what `all` was at the last row of the series
    clod_impact_class of[CLOD_IMPACT_ANGLES][CLOD_IMPACT_ENERGIES];
} clod_impacts;

/**
 * An impact of a grain.
 *
 * @param mass      kg
 * @param approach  speed of the centre towards the surface [m/s], > 0
 * @param speed2    square of its speed against the material [m2/s2], >= approach^2 but for rounding
 */
clod_impact clod_impact_of(double mass, double approach, double speed2);

/** Add an impact. Errors none. Threads one per table. */
void clod_impacts_add(clod_impacts *self, const clod_impact *impact);

/** Lowest normal energy of a class [J]: 0, then 1, 2, 5 of each decade from 1e-12 on; that of class
 *  CLOD_IMPACT_ENERGIES is infinite. */
double clod_impacts_energy_from(int class);

/** Impacts of one class of angles. */
clod_impact_class clod_impacts_at_angle(const clod_impacts *self, int angle);

/** Impacts of one class of normal energies. */
clod_impact_class clod_impacts_with_energy(const clod_impacts *self, int energy);
