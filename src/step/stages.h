#pragma once
/**
 * @file stages.h
 * The table of the step: what happens, from top to bottom. Every step runs it; behind the last one of
 * a call the table of last stages is run once.
 */

#include "step/step.h"

/** What a stage reads and writes. */
enum {
    CLOD_STAGE_POSITION = 1 << 0,
    CLOD_STAGE_VELOCITY = 1 << 1,
    CLOD_STAGE_LISTS = 1 << 2,
    CLOD_STAGE_SHARE = 1 << 3, ///< of contacts between two threads' grains
    CLOD_STAGE_HISTORY = 1 << 4,
    CLOD_STAGE_FORCE = 1 << 5,      ///< of this step, and with the ledger of the one before
    CLOD_STAGE_WALL_SUM = 1 << 6,   ///< forces on walls, by parts
    CLOD_STAGE_WALLS = 1 << 7,      ///< where they are and how they move
    CLOD_STAGE_SURFACES = 1 << 8,   ///< rows of their shapes
    CLOD_STAGE_DISSIPATED = 1 << 9, ///< by each contact, with the energy ledger
    CLOD_STAGE_DISSIPATED_SUMS = 1 << 10, ///< of them, by threads
    CLOD_STAGE_LEDGER = 1 << 11,
    CLOD_STAGE_SEEN = 1 << 12,   ///< by drift: the fastest, and whether numbers are finite
    CLOD_STAGE_EXCESS = 1 << 13, ///< an overlap beyond the laws' range
    CLOD_STAGE_TOUCH = 1 << 14,  ///< closest points of meshes
    CLOD_STAGE_RUB = 1 << 15,    ///< of each contact with a wall, with the sums of surfaces
    CLOD_STAGE_WEAR = 1 << 16,   ///< sums of each place of the walls
    CLOD_STAGE_PASSED = 1 << 17, ///< what has passed planes
};

/** For these, those who need what others write wait at gates. */
#define CLOD_STAGE_GATED (CLOD_STAGE_SHARE | CLOD_STAGE_SURFACES)

/** Of these, every thread touches its own grains' and contacts' alone. */
#define CLOD_STAGE_OWN                                                                         \
    (CLOD_STAGE_FORCE | CLOD_STAGE_HISTORY | CLOD_STAGE_DISSIPATED | CLOD_STAGE_TOUCH)

/** Of these, every thread writes its own; another stage reads those of all. */
#define CLOD_STAGE_EACH (CLOD_STAGE_SEEN | CLOD_STAGE_EXCESS | CLOD_STAGE_PASSED)

/** Where all threads wait for each other. */
typedef enum clod_stage_barrier {
    CLOD_BARRIER_NONE,
    CLOD_BARRIER_AFTER,  ///< all finish the stage before the next one begins
    CLOD_BARRIER_WITHIN, ///< where it writes anything, it begins and ends with one
    CLOD_BARRIER_RANKS, ///< after it with several ranks; one rank alone has nothing to do there
} clod_stage_barrier;

/**
 * A stage. A barrier stands between two stages of which one writes what the other reads or
 * writes, but for what is gated, a thread's own, or touched by thread 0 alone in both.
 * Two stages may write what each thread has one of.
 * Test  tests/step/test_stages.c
 */
typedef struct clod_stage {
    const char *name;
    void (*run)(clod_step *self, int part); ///< `part` is the thread's number
    int reads, writes;
    int by_first; ///< of them, what only thread 0 reads and writes here
    clod_stage_barrier barrier;
} clod_stage;

#define CLOD_STAGES 12
#define CLOD_LAST_STAGES 3

extern const clod_stage CLOD_STAGE[CLOD_STAGES];
extern const clod_stage CLOD_LAST_STAGE[CLOD_LAST_STAGES]; ///< after the last step of a call
