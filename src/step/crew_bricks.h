#pragma once
/**
 * @file crew_bricks.h
 * A box cut into equal bricks, one for each rank.
 *
 * Threads  pure.   Test  tests/step/test_crew_places.c
 */

#include "state/domain.h"

/** How many there are along each axis: the longest edge is cut by the largest prime factor that is left. */
void clod_crew_bricks(const clod_domain_box *box, int ranks, int32_t bricks[3]);

/** The rank whose brick a point is in; beside the box: the next one. */
int clod_crew_brick_of(const clod_domain_box *box, const int32_t bricks[3],
                       const double place[4]);

/** A rank's brick. */
clod_domain_box clod_crew_brick(const clod_domain_box *box, const int32_t bricks[3], int rank);
