#pragma once
/**
 * @file calibrate.h
 * Parameters of a material from measured targets: `clod calibrate`. docs/theory/calibration.md has the
 * equations, docs/howto/calibrate.md the plan.
 */

#include "clod/run.h"
#include "clod/schema.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clod_calibrate_options {
    const char *program; ///< path of clod, which is run for every point
    const char *const
        *overrides; ///< [override_count] key.path=value, in place of what the plan says
    size_t override_count;
    const char *directory; ///< of runs and results; NULL: run/NAME for NAME.yaml
    int workers;           ///< runs side by side; 0: one for each processor
    bool dry;              ///< only check plan, cases and tables
    clod_run_signal *stop; ///< not zero: stop with checkpoints; or NULL
    void (*tell)(void *context, const char *text); ///< a line for people; or NULL
    void *context;
} clod_calibrate_options;

/**
 * Read a plan, run its design, calibrate, and write calibration.json, card.yaml, posterior.csv, runs.csv and
 * report.txt into the folder. The same call goes on after an interruption.
 *
 * @param report  [out] owned text for people (clod_calibrate_free)
 * Errors  CLOD_USAGE: plan, cases, tables, folder, budget; CLOD_FAILED: disk, memory, a test that fails;
 *         CLOD_INTERRUPTED.   Threads  one per folder.   Test  tests/calibrate/
 */
bool clod_calibrate_run(const char *path, const clod_calibrate_options *options, char **report,
                        clod_status *status);

/** Keys of a plan, for clod_schema_explain. Threads  pure. */
const clod_schema *clod_calibrate_schema(void);

/** Free a text; NULL is fine. */
void clod_calibrate_free(char *text);

#ifdef __cplusplus
}
#endif
