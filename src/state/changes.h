#pragma once
/**
 * @file changes.h
 * Grains and walls that come and go: a queue that anyone fills between steps, and the counts of
 * what has come and gone. The step makes the changes at a rebuild (clod_step_change).
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/status.h"
#include "state/clump_class.h"
#include "state/domain.h"
#include "state/grains.h"
#include "state/time_class.h"
#include "state/walls.h"

/** A grain that is to come; mass and inertia follow from radius and density. */
typedef struct clod_new_grain {
    uint64_t id;                ///< no other grain has it
    double position[4];         ///< x, y, z, radius [m]
    double velocity[3];         ///< m/s
    double angular_velocity[3]; ///< rad/s
    double density;             ///< kg/m3
    uint16_t material;
} clod_new_grain;

/** What is to change; all zero: nothing. Not part of a checkpoint: it is empty at one. */
typedef struct clod_changes {
    clod_new_grain *new_grain; ///< owned, as the rest
    uint64_t *lost_grain;      ///< ids
    clod_wall *new_wall;       ///< with their shapes
    char (*lost_wall)[32];     ///< names
    size_t new_grains, lost_grains, new_walls, lost_walls;
    size_t new_grain_room, lost_grain_room, new_wall_room, lost_wall_room;
    size_t checked;    ///< of new_grains: whoever asked knows that laws and time step suit them
    bool moved;        ///< somebody moved grains or walls otherwise than by a step
    bool booked;       ///< and what that does to the energy belongs into the ledger
    double energy;     ///< J, then: that before it
    bool lacks_memory; ///< something could not be put in
} clod_changes;

/** Sides of the domain: x min, x max, y min, y max, z min, z max. */
#define CLOD_FACES 6
/** Ways out: the sides, then the outlets. */
#define CLOD_EXITS (CLOD_FACES + CLOD_OUTLETS)

/** What has come and gone since the beginning of the run. */
typedef struct clod_exchange {
    int64_t walls_removed;
    int64_t added, removed;         ///< grains, by the queue
    double added_mass;              ///< kg
    double removed_mass;            ///< kg
    int64_t left[CLOD_EXITS];       ///< grains that went out and were removed
    double left_mass[CLOD_EXITS];   ///< kg
    double left_energy[CLOD_EXITS]; ///< J, their kinetic energy, of rotation included
    // times that grains were in: of those that came during a run and left at residence_since
    // or later
    double residence_since;                      ///< s
    double residence;                            ///< s, sum
    double residence_squared;                    ///< s2, of their squares
    double residence_least, residence_most;      ///< s
    int64_t residence_count[CLOD_TIME_CLASSES];  ///< how many were in for so long
    int64_t left_clumps[1 + CLOD_CLUMP_CLASSES]; ///< how many were alone, and in clumps of each
                                                 ///< class, at the last look; 0: nobody looks
} clod_exchange;

/**
 * Put one change into the queue. They are made together: what goes before what comes.
 *
 * Errors  without memory the queue is as before and notes that; unless the caller says so
 * (clod_sim_add_grain), clod_step_change does, and changes nothing. Threads one per queue.   Test  tests/step/test_change.c
 */
void clod_changes_add_grain(clod_changes *self, const clod_new_grain *grain);
void clod_changes_remove_grain(clod_changes *self, uint64_t id);
/** Its shapes are taken over: `wall` has none then. */
void clod_changes_add_wall(clod_changes *self, clod_wall *wall);
void clod_changes_remove_wall(clod_changes *self, const char *name);

/** Append a new grain to those that there are; mass and inertia as clod_grains_add. */
bool clod_new_grain_join(const clod_new_grain *self, clod_grains *to, clod_status *status);

/** Grains or walls were put elsewhere: contacts that are open now are forgotten. */
static inline void clod_changes_moved(clod_changes *self)
{
    self->moved = true;
}

/** The same, and the ledger gets what it does to the energy: from that before the first of them to
 *  that with the lists of neighbours made anew. */
static inline void clod_changes_moved_from(clod_changes *self, double energy)
{
    self->booked = !self->moved || self->booked;
    self->energy = self->moved ? self->energy : energy;
    self->moved = true;
}

/** Whether anything is to change. */
static inline bool clod_changes_any(const clod_changes *self)
{
    return self->lacks_memory || self->moved ||
           self->new_grains + self->lost_grains + self->new_walls + self->lost_walls > 0;
}

/** Empty the queue and free its memory. */
void clod_changes_fini(clod_changes *self);
