#pragma once
/**
 * @file bed.h
 * Run a whole bed from the text of a case: written to DIR/cases/NAME/case.yaml, loaded as a
 * user's case, stepped through its stages as `clod run` steps it, with a look at every row of
 * what would be its series (output.series_interval).
 */

#include "law/law.h"
#include "sim/free_stages.h"
#include "sim/inlets.h"
#include "step/step.h"
#include "verify/bench.h"

typedef struct clod_verify_bed {
    clod_case *from;
    clod_laws laws;
    clod_state state;
    clod_step step;
    clod_free_stages stages;
    clod_inlets inlets;
} clod_verify_bed;

/**
 * Called before the first step, and wherever `clod run` writes a row: walls have their mean
 * force since the last row in sum_force/sum_steps, and the stage is the one that led there.
 */
typedef bool (*clod_verify_bed_look)(void *context, clod_verify_bed *now, clod_status *status);

/**
 * Run a bed from its first stage to the end of its last, on all processors.
 *
 * @param name  of its folder below DIR/cases
 * @param text  of the case file
 * @param look  sees the bed; false ends the run
 * Errors  CLOD_FAILED, CLOD_USAGE: what loader, set-up or engine say.   Threads  one at a time.
 * Test    tests/verify/test_bed.c
 */
bool clod_verify_bed_run(const clod_verify_bench *bench, const char *name, const char *text,
                         clod_verify_bed_look look, void *context, clod_status *status);

/** Whether the bed is in the stage of this name. */
bool clod_verify_bed_is_in(const clod_verify_bed *self, const char *stage);

/** Write the contacts into the state and find the largest overlap of a pair over its smaller
 * radius. */
bool clod_verify_bed_overlap(clod_verify_bed *self, double *overlap, clod_status *status);
