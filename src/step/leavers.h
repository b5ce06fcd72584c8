#pragma once
/**
 * @file leavers.h
 * Grains that leave: through an open side of a domain that removes them, through outlets.
 */

#include <stddef.h>
#include <stdint.h>

#include "parallel/exact.h"
#include "state/state.h"
#include "step/outlet_shapes.h"

/** The open side that a position is beyond, as in clod_exchange, or -1. */
int clod_leavers_face(const clod_domain *domain, const double *position);

/** Surfaces that remove grains, where they are now; borrowed. */
typedef struct clod_leavers_outlets {
    const clod_outlet_shapes *shapes;
    const clod_wall_rows *rows;
} clod_leavers_outlets;

/** The way out that a grain takes, of CLOD_EXITS: a side that removes, a region, a surface; or
 *  -1. */
int clod_leavers_exit(const clod_leavers_outlets *outlets, const clod_domain *domain,
                      const double *position);

/** Grains that leave at one rebuild. Sums are exact: the order of rows does not matter, nor how
 *  they are dealt to ranks. All zero: none. */
typedef struct clod_leavers {
    int64_t grains;
    int64_t left[CLOD_EXITS];
    clod_exact mass[CLOD_EXITS], energy[CLOD_EXITS]; ///< kg, J
    clod_exact kick;                        ///< J that the half kick to come would have brought
    clod_exact time, time_squared;          ///< s, s2, that they were in
    int64_t timed;                          ///< how many of them came during the run
    double residence_least, residence_most; ///< s
    int64_t residence_count[CLOD_TIME_CLASSES];
    int64_t left_clumps[1 + CLOD_CLUMP_CLASSES];
} clod_leavers;

/**
 * At a rebuild: add and mark them.
 *
 * @param half_kick  s for which the velocities still lack their weight: dt/2 in the middle of a
 *                   step, of whose forces only that is known; 0 between steps
 * @param rank       [grains] [in,out] theirs becomes CLOD_NEIGHBOUR_GOES; those that go already
 *                   are left alone
 * @return           how many
 * Errors  none.   Threads  one, the others wait.   Test  tests/step/test_leave.c
 */
size_t clod_leavers_mark(clod_leavers *sums, clod_state *state,
                         const clod_leavers_outlets *outlets, double half_kick, int32_t *rank);

/** Add those of another rank. */
void clod_leavers_merge(clod_leavers *self, const clod_leavers *other);

/** Into state->exchange, and the ledger. */
void clod_leavers_book(const clod_leavers *self, clod_state *state);
