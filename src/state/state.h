#pragma once
/**
 * @file state.h
 * Everything that changes during a run and must be in a checkpoint to go on with the same bits.
 */

#include <stdint.h>

#include "state/changes.h"
#include "state/contacts.h"
#include "state/domain.h"
#include "state/gone.h"
#include "state/grains.h"
#include "state/ledger.h"
#include "state/planes.h"
#include "state/walls.h"

typedef struct clod_state {
    clod_grains grains;
    clod_walls walls;
    clod_domain domain;
    double gravity[3]; ///< m/s2
    double dt;         ///< s
    double time;       ///< s = step * dt
    int64_t step;
    double adhesion; ///< k_adh as a fraction of its final value
    clod_ledger ledger;
    clod_exchange exchange; ///< grains that have come and gone
    clod_changes changes;   ///< asked for, not made yet: none at a checkpoint or in a copy
    clod_gone gone;         ///< grains that left, when somebody wants them one by one
    clod_planes planes;     ///< what has passed them
    // the neighbour search at its last rebuild; decides when the grains are sorted next
    double (*build_position)[4]; ///< [build_capacity] at the last rebuild, in today's order
    size_t build_capacity;       ///< that of the grains when the array was made: they may grow
    double (*build_walls)[CLOD_WALL_POSE_NUMBERS]; ///< [walls.count] poses at the last rebuild
    double build_motion; ///< m, bound of any point's motion since then; < 0: rebuild now
    double build_skin;   ///< m, wide skin of that rebuild
    // contacts with history (touching), sorted by (i, j) and by (i, wall, shape): those of a
    // state that no step has; a step keeps them in its blocks, and clod_step_export copies
    // those of the moment to here
    clod_contact *contacts;
    size_t contact_count, contact_capacity;
    size_t wall_contact_count; ///< the last ones of `contacts` are grain-wall
} clod_state;

/** Deep copy into an empty state. */
bool clod_state_copy(clod_state *self, const clod_state *from, clod_status *status);

/** Room for the positions of all grains at a rebuild, in place of an earlier one; false without
 *  memory. */
bool clod_state_reserve_build(clod_state *self);

void clod_state_fini(clod_state *self);
