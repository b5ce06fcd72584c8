#pragma once
/**
 * @file wear.h
 * What grains do to each place of a wall: sums over time of force, work, impacts and what wear
 * follows from. A place is a facet of a mesh, or a whole shape that is none. Only walls that were
 * asked to have these sums (output.surfaces).
 *
 * Source  docs/theory/wear.md.   Test  tests/step/test_wear.c
 */

#include "state/walls.h"

/** Columns of the sums of a place. */
enum {
    CLOD_WEAR_IMPULSE = 0,  ///< x, y, z: of the grains' force on it [N s]
    CLOD_WEAR_PRESS = 3,    ///< of that force into the surface [N s]; below 0 grains pull
    CLOD_WEAR_SHEAR = 4,    ///< of friction force times sliding speed [J]
    CLOD_WEAR_SQUEEZE = 5,  ///< of normal force times approach speed, while they approach [J]
    CLOD_WEAR_IMPACTS = 6,  ///< number of contacts that began
    CLOD_WEAR_ENERGY = 7,   ///< of the grains' kinetic energy relative to it at impact [J]
    CLOD_WEAR_ANGLE = 8,    ///< of that energy times the angle of impact [J rad]
    CLOD_WEAR_SLIDING = 9,  ///< of pressing force times sliding speed [J]: Archard
    CLOD_WEAR_CUTTING = 10, ///< of force times speed times f(angle), twice [J]: Finnie
    CLOD_WEAR_COLUMNS = CLOD_WEAR_SUMS
};

/** What is told of a column. */
typedef struct clod_wear_column {
    const char *name, *unit;
} clod_wear_column;

extern const clod_wear_column CLOD_WEAR_COLUMN[CLOD_WEAR_COLUMNS];

/**
 * Begin the sums of a wall, at zero; each shape knows its first place then (clod_shape.place).
 * Errors  false without memory.
 */
bool clod_wear_begin(clod_wall *wall);

/** Set all sums of a wall to zero, if it has any. */
void clod_wear_reset(clod_wall *wall);

/** Number the places of a wall's shapes: facets of each mesh, and other shapes; how many. */
int32_t clod_wear_number_places(clod_wall *wall);

/** Area of a place [m2]; 0 for shapes without a bound. */
double clod_wear_area(const clod_wall *wall, int32_t shape, int32_t place);

/**
 * Finnie's function of the angle between velocity and surface: sin 2g - 3 sin2 g where tan g <
 * 1/3, else cos2 g/3.
 *
 * @param normal, along  speeds into and along the surface [m/s], >= 0, not both 0
 * Source  Finnie 1960.   Test  tests/step/test_wear.c
 */
double clod_wear_finnie(double normal, double along);
