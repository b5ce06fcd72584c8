#pragma once
/**
 * @file resting.h
 * Which grains rest on which wall (docs/clumps.md): those slower than a speed against the wall's
 * material that touch it, and those slower that touch such a grain, and so on.
 */

#include "measure/survey.h"

/** Of one grain. */
typedef struct clod_resting {
    int32_t wall;  ///< that it rests on; -1: none
    int32_t shape; ///< of the wall
    int32_t steps; ///< contacts from it to the wall along the shortest way, 1 or more
} clod_resting;

/**
 * Find the wall that each grain rests on: the one with fewest contacts between; of several the
 * first, and of its shapes the first that the grain itself touches, or that of the grain with
 * the smallest id on whose side it hangs. Ranks go one contact farther from the walls together, until
 * none comes to a grain that it did not know.
 *
 * @param to     [out] [grains.count] by row, of own grains
 * @param here   its contacts know the wall's material; else nothing rests
 * @param speed  m/s
 * @return       false on all ranks alike
 * Errors  CLOD_FAILED: memory.   Threads  one of each rank, all at the same time.
 * Test    tests/measure/test_resting.c, test_resting_ranks.c, tests/step/test_ranks_survey.c
 */
bool clod_resting_find(clod_resting *to, const clod_survey_part *here, double speed,
                       clod_status *status);
