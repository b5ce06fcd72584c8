#pragma once
/**
 * @file leavers.h
 * Grains that leave: through an open side of a domain that removes them, through outlets.
 */

#include <stddef.h>
#include <stdint.h>

#include "state/state.h"
#include "step/outlet_shapes.h"

/** The open side that a position is beyond, as in clod_exchange, or -1. */
int clod_leavers_face(const clod_domain *domain, const double *position);

/** Surfaces that remove grains, where they are now; borrowed. */
typedef struct clod_leavers_ways {
    const clod_outlet_shapes *shapes;
    const clod_wall_rows *rows;
} clod_leavers_ways;

/**
 * At a rebuild: count them in state->exchange and mark them. Sums are exact: the order of rows
 * does not matter.
 *
 * @param half_kick  s for which the velocities still lack their weight: dt/2 in the middle of a
 *                   step, of whose forces only that is known; 0 between steps
 * @param rank       [grains] [in,out] theirs becomes CLOD_NEIGHBOUR_GOES; those that go already
 *                   are left alone
 * @return           how many
 * Errors  none.   Threads  one, the others wait.   Test  tests/step/test_leave.c
 */
size_t clod_leavers_mark(clod_state *state, const clod_leavers_ways *ways, double half_kick,
                         int32_t *rank);
