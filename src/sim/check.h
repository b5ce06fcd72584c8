#pragma once
/**
 * @file check.h
 * The parts of the preflight.
 */

#include "clod/check.h"
#include "law/law.h"
#include "setup/timestep.h"
#include "state/state.h"

/** A case made ready to look at. */
typedef struct clod_check_subject {
    const clod_case *from;
    const clod_check_options *options;
    clod_state state;
    clod_timestep timestep;
    int material; ///< of the first grain
    clod_law law; ///< between two grains of that material
} clod_check_subject;

/** Steps of the run, rate of the step, time on the clock, memory and disk. */
bool clod_check_cost(const clod_check_subject *subject, clod_check_report *report,
                     clod_status *status);

/** What may go wrong with the case, why, and what to do. */
void clod_check_warn(const clod_check_subject *subject, clod_check_report *report);
