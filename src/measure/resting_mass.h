#pragma once
/**
 * @file resting_mass.h
 * Mass that rests on walls and on parts of their meshes, of a bed wherever its grains are.
 */

#include "measure/resting.h"
#include "parallel/exact.h"

/** A wall, or a part of a mesh of it. */
typedef struct clod_resting_target {
    int32_t wall;  ///< number among the walls of now
    int32_t first; ///< first shape of the mesh
    int32_t part;  ///< of it; -1: all of the wall
} clod_resting_target;

/** What is weighed; plain data. */
typedef struct clod_resting_question {
    double speed; ///< m/s, of clod_resting_find
    size_t count;
    clod_resting_target target[]; ///< [count]
} clod_resting_question;

/**
 * Weigh what rests on each.
 *
 * @param mass  [asked->count] [out] kg
 * Errors  CLOD_FAILED: memory.   Threads  one per bed.   Test  tests/step/test_ranks_survey.c
 */
bool clod_resting_mass(const clod_resting_question *asked, const clod_survey *survey,
                       clod_exact *mass, clod_status *status);

extern const clod_survey_way CLOD_RESTING_MASS_WAY;
