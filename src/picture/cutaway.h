#pragma once
/**
 * @file cutaway.h
 * What of the walls stands in the way: planes without an end are cut to a box, faces between the
 * eye and the grains are drawn as veils.
 */

#include "base/vec3.h"
#include "clod/status.h"
#include "picture/faces.h"

/** A box along the axes; empty when min is above max. */
typedef struct clod_cutaway_box {
    double min[3], max[3];
} clod_cutaway_box;

#define CLOD_CUTAWAY_EMPTY                                                                     \
    ((clod_cutaway_box){{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}})

/** Make a box contain a point. */
void clod_cutaway_include(clod_cutaway_box *box, const double point[3]);

/** Triangles at most of a square that was cut. */
#define CLOD_CUTAWAY_PIECES 8

/**
 * Cut a square to a box.
 *
 * @param corner  the first of its two triangles; the other one lies behind it
 * @param piece   [out] triangles of what is left
 * @return        how many
 */
size_t clod_cutaway_clip(const clod_cutaway_box *box, double (*const corner)[3][3],
                         double piece[CLOD_CUTAWAY_PIECES][3][3]);

/**
 * Set scene->veiled: of faces that hide more than a few of the grains from the eye, the side
 * that is turned to them. Named parts of a face are judged apart: the return of a belt stays as
 * it is when only a run hides grains. Those that hide few each are veiled if they hide more
 * than a few together.
 * Errors  CLOD_FAILED: no memory.   Threads  pure.   Test  tests/picture/test_cutaway.c
 */
bool clod_cutaway_veil(clod_scene *scene, const clod_faces *faces, clod_vec3 eye,
                       clod_status *status);
