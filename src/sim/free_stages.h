#pragma once
/**
 * @file free_stages.h
 * The stages of a free run: each sets walls and adhesion when it begins and lasts its time, or
 * until the grains are at rest. Between two rows of the series nothing changes.
 *
 * clod_free_run writes the rows; src/verify looks at the state instead. Whoever steps asks
 * clod_free_stages_plan how far, and calls clod_free_stages_next there.
 */

#include <stdbool.h>

#include "clod/case.h"
#include "state/state.h"

/** Where the run is; plain data, part of the checkpoint. */
typedef struct clod_free_stages {
    int64_t stage;
    int64_t stage_start; ///< step
    int64_t rows;        ///< of this stage
} clod_free_stages;

/** Begin the first stage. */
void clod_free_stages_begin(clod_free_stages *self, const clod_case *from, clod_state *state);

/** Steps until the next row. Threads: pure. */
int64_t clod_free_stages_plan(const clod_free_stages *self, const clod_case *from,
                              const clod_state *state);

/**
 * A row's time has come: reset the walls' sums, and begin the next stage when this one is over;
 * the laws' adhesion then is state->adhesion.
 *
 * @return  true after the last stage
 */
bool clod_free_stages_next(clod_free_stages *self, const clod_case *from, clod_state *state);

/** Name of the stage; of the case. */
const char *clod_free_stages_name(const clod_free_stages *self, const clod_case *from);

/** What is done of all stages, 0 to 1. */
double clod_free_stages_fraction(const clod_free_stages *self, const clod_case *from);
