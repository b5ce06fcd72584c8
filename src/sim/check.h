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
    clod_state state; ///< before the first step
    double expected;  ///< grains of the case when the state has only a sample of them; else 0
    clod_timestep timestep;
    int material; ///< of the first grain
    clod_law law; ///< between two grains of that material
} clod_check_subject;

/** Bytes that a grain takes. */
typedef struct clod_check_bytes {
    double contacts, blocks; ///< histories: a large bed holds them once, a small one in both
    double scratch;          ///< while lists are made (docs/adr/0016)
    double other;
} clod_check_bytes;

/**
 * Time the step on a packing of the preflight's own. When that goes wrong the rates stay 0 and
 * a note says so.
 * Errors  CLOD_USAGE: unknown instruction set.
 */
bool clod_check_rate(const clod_check_subject *subject, clod_check_report *report,
                     clod_check_bytes *bytes, clod_status *status);

/** Steps of the run, rate of the step, time on the clock, memory and disk. */
bool clod_check_cost(const clod_check_subject *subject, clod_check_report *report,
                     clod_status *status);

/** How many times as long as at the rate measured the steps of a case may take: more than 1 where grains come during
 *  the run, for these may be a dense fast stream. Threads: pure. */
double clod_check_slower(const clod_case *from);

/** Add a note to the report, as long as there is room. */
void clod_check_note(clod_check_report *report, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/**
 * What softening costs: step, overlaps and impacts beside those of the stiffness as given.
 * Errors  CLOD_FAILED without memory.
 */
bool clod_check_soften(const clod_check_subject *subject, clod_check_report *report,
                       clod_status *status);

/** Warnings and notes of a case that is softened. */
void clod_check_soften_warn(const clod_check_subject *subject, clod_check_report *report);

/** What may go wrong with the case, why, and what to do. */
void clod_check_warn(const clod_check_subject *subject, clod_check_report *report);
