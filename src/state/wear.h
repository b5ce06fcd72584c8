#pragma once
/**
 * @file wear.h
 * What grains do to each place of a wall: sums over time of force, work, impacts and what wear
 * follows from. A place is a facet of a mesh, or a whole shape that is none. Places make surfaces:
 * each named part of a mesh is one, and each other shape. Only walls that were asked to have
 * these sums (output.surfaces).
 *
 * Source  docs/theory/wear.md.   Test  tests/step/test_wear.c
 */

#include "state/impacts.h"
#include "state/walls.h"

/** Columns of the sums of a place: what each contact adds in every step, then what an impact does. */
enum {
    CLOD_WEAR_IMPULSE = 0, ///< x, y, z: of the grains' force on it [N s]
    CLOD_WEAR_PRESS = 3,   ///< of that force into the surface [N s]; below 0 grains pull
    CLOD_WEAR_SHEAR = 4,   ///< of friction force times sliding speed [J]
    CLOD_WEAR_SQUEEZE = 5, ///< of normal force times approach speed, while they approach [J]
    CLOD_WEAR_SLIDING = 6, ///< of pressing force times sliding speed [J]: Archard
    CLOD_WEAR_CUTTING = 7, ///< of force times speed times f(angle), twice [J]: Finnie
    CLOD_WEAR_IMPACTS = 8, ///< number of impacts
    CLOD_WEAR_ENERGY = 9,  ///< of the energy of the grains' approach, m v_n^2/2, at impact [J]
    CLOD_WEAR_ANGLE = 10   ///< of that energy times the angle of impact [J rad]
};

/** Columns that each contact adds to in every step: the first ones. */
#define CLOD_WEAR_STEP_SUMS 8

/** Begin the sums of a wall, at zero. Errors  false without memory. */
bool clod_wear_begin(clod_wall *wall);

/** Begin the sums of a wall anew at a time [s], if it has any. */
void clod_wear_reset(clod_wall *wall, double time);

/** Number the places and surfaces of a wall's shapes (clod_shape.place, face); how many places. */
int32_t clod_wear_number(clod_wall *wall);

/** Number of surfaces of a wall whose shapes are numbered. */
int32_t clod_wear_faces(const clod_wall *wall);

/** Number of surfaces of a wall that has sums; 0 of one without, as a program may add. */
static inline int32_t clod_wear_summed(const clod_wall *wall)
{
    return wall->wear != NULL ? clod_wear_faces(wall) : 0;
}

/** Rows that the sums of a wall need: those of places, and of each surface two and its impacts. */
int32_t clod_wear_rows(const clod_wall *wall, int32_t places);

/** How grains hit a surface of a wall that has sums; borrowed. */
clod_impacts *clod_wear_impacts(const clod_wall *wall, int32_t face);

/** A place, the shape with which grains touch it, and its surface; numbers of the wall. */
typedef struct clod_wear_place {
    int32_t shape, place, face;
} clod_wear_place;

/** Look at a place of a wall. */
typedef void (*clod_wear_look)(void *context, const clod_wall *wall, clod_wear_place at);

/** Look at every place of a wall whose shapes are numbered. */
void clod_wear_visit(const clod_wall *wall, clod_wear_look look, void *context);

/** Bytes of the name of a surface. */
#define CLOD_WEAR_NAME (CLOD_WALL_NAME + CLOD_SURFACE_LABEL)

/**
 * Name of a surface, the only one in its walls: WALL.PART with the part's label (part_labels.h),
 * WALL.NUMBER, or WALL where it has no other.
 *
 * @param text  [size] [out] CLOD_WEAR_NAME bytes hold any name
 */
void clod_wear_name(const clod_wall *wall, int32_t face, char *text, size_t size);

/** Area of a place of a shape [m2]; 0 for shapes without a bound. */
double clod_wear_area(const clod_wall *wall, int32_t shape, int32_t place);
