#pragma once
/**
 * @file testers.h
 * Kinds of case as src/sim sees them: one row for each clod_case_kind with all that a run, its
 * trial, the preflight and the reports do for it alone. What is NULL there is nothing to do.
 * What the case file says of each is in config/testers.c, its cell in setup/begin.c.
 */

#include "sim/check_testers.h"
#include "sim/parts.h"
#include "sim/shear_cell.h"

typedef struct clod_tester_row {
    /** Run it, and make the report. NULL: there is nothing to run, nor to estimate. */
    bool (*run)(const clod_job_shared *sim, char **report, clod_status *status);
    /** Whether it can begin with what another run has left; nothing is written. */
    bool (*try_origin)(const clod_job_shared *sim, clod_status *status);
    /** What happens between the steps of its first part, for the trial (sim/trial.h). */
    const clod_parts_tester *first;
    clod_shear_cell (*cell)(const clod_case *from); ///< of a shear test

    // preflight
    /** Fill in what the report says of this kind alone. */
    bool (*look)(const clod_check_subject *subject, clod_check_report *report,
                 clod_status *status);
    /** The batches of a run, each after the one before; returns how many. `most`: as long as
     *  the limits of the case allow, else as long as is likely. */
    int (*batches)(const clod_case *from, bool most, clod_check_batch all[CLOD_CHECK_BATCHES]);
    void (*warn)(const clod_check_subject *subject, clod_check_report *report);
    const char *stress; ///< name of the report's stress, of a test
    /** Lines of the report; of a test of several parts, whose length is a guess. */
    void (*write)(clod_check_page *to, const clod_check_report *report);
    void (*put)(json_t *to, const clod_check_report *report); ///< numbers of the JSON
} clod_tester_row;

/**
 * Row of a kind of case.
 *
 * Errors  none.   Threads  pure.   Test  tests/sim/test_testers.c
 */
const clod_tester_row *clod_testers_row(clod_case_kind kind);

/** Row of the kind that a case is of. */
const clod_tester_row *clod_testers_of(const clod_case *from);
