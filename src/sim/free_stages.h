#pragma once
/**
 * @file free_stages.h
 * The stages of a free run: each sets walls and adhesion when it begins and lasts its time, or
 * until the grains are at rest. Between two rows of the series nothing changes.
 *
 * At rest are grains of which none is faster than the stage's `rest` at CLOD_FREE_LOOKS looks
 * in a row, while some of them carry load. The looks have their own spacing, whatever is
 * written: all of them together last as long as a grain in free fall could be slower than that.
 *
 * clod_free_run writes the rows; src/verify looks at the state instead. Whoever steps asks
 * clod_free_stages_plan how far, clod_free_stages_look what is there, and calls
 * clod_free_stages_next where a row is due.
 */

#include <stdbool.h>

#include "clod/case.h"
#include "measure/survey.h"

enum { CLOD_FREE_LOOKS = 5 }; ///< in a row, to be at rest

/** Why a stage ended. */
typedef enum clod_free_end {
    CLOD_FREE_GOES_ON,
    CLOD_FREE_DURATION, ///< its whole time is over
    CLOD_FREE_AT_REST,
} clod_free_end;

/** How a stage ended; plain data, part of the checkpoint. */
typedef struct clod_free_stage_end {
    int64_t step;
    int64_t reason; ///< clod_free_end
} clod_free_stage_end;

/** Where the run is; plain data, part of the checkpoint. */
typedef struct clod_free_stages {
    int64_t stage;
    int64_t stage_start; ///< step
    int64_t calm;        ///< looks in a row at which the grains were at rest
    double done;         ///< s of the stage at the last look
    int64_t end;         ///< clod_free_end of the stage, at its last look
} clod_free_stages;

/** Begin the first stage. */
void clod_free_stages_begin(clod_free_stages *self, const clod_case *from, clod_state *state);

/** Steps until the next look or row. Threads: pure. */
int64_t clod_free_stages_plan(const clod_free_stages *self, const clod_case *from,
                              const clod_state *state);

/**
 * After the planned steps: see whether the grains are at rest, if it is time for that.
 *
 * @return  true when a row is due: by its interval, or because the stage ends here
 */
bool clod_free_stages_look(clod_free_stages *self, const clod_case *from,
                           const clod_state *state, const clod_survey *survey);

/**
 * A row's time has come: reset the walls' sums, and begin the next stage when this one is over;
 * the laws' adhesion then is state->adhesion.
 *
 * @return  true after the last stage
 */
bool clod_free_stages_next(clod_free_stages *self, const clod_case *from, clod_state *state);

/** Name of the stage; of the case. */
const char *clod_free_stages_name(const clod_free_stages *self, const clod_case *from);

/** "at rest" or "its duration is over". */
const char *clod_free_stages_reason(clod_free_end end);

/** What is done of all stages, 0 to 1. */
double clod_free_stages_fraction(const clod_free_stages *self, const clod_case *from);
