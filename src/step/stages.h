#pragma once
/**
 * @file stages.h
 * The table of the step: what happens, from top to bottom. The step and the stage bench run it.
 */

#include "step/step.h"

/** What a stage reads and writes, for the reader and for the order of barriers. */
enum {
    CLOD_STAGE_POSITION = 1,
    CLOD_STAGE_VELOCITY = 2,
    CLOD_STAGE_CONTACT_LIST = 4,
    CLOD_STAGE_SHARE = 8, ///< of contacts between two threads' grains; they wait at gates
    CLOD_STAGE_HISTORY = 16,
    CLOD_STAGE_FORCE = 32,
    CLOD_STAGE_WALL_FORCE = 64,
    CLOD_STAGE_WALLS = 128,
    CLOD_STAGE_SURFACES = 256, ///< rows of shapes; they wait at gates
    CLOD_STAGE_LEDGER = 512,
};

typedef struct clod_stage {
    const char *name;
    void (*run)(clod_step *self, int part); ///< `part` is the thread's number
    int reads, writes;
    bool wait; ///< a barrier follows: all threads finish it before the next stage begins
} clod_stage;

#define CLOD_STAGES 7

extern const clod_stage CLOD_STAGE[CLOD_STAGES];
