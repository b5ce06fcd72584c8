#pragma once
/**
 * @file runs.h
 * The runs of a calibration: processes side by side, each in a folder of its own, with a row for each
 * that has ended, so that the same command goes on where it was.
 */

#include <limits.h>

#include "base/warning_list.h"
#include "calibrate/plan.h"
#include "calibrate/stop.h"
#include "output/folder.h"

#define CLOD_RUNS_FOLDER "runs" ///< below that of the calibration
#define CLOD_RUNS_NAME 128      ///< bytes of a run's name

/** Seeds of two neighbouring tests are so far apart: more than a test has packings (CLOD_PLAN_POINTS times 20), so no two
 *  tests share one, however many points come later. A plan has 1 MiB, so 1e5 tests at most, and its own seed is up to 1e9:
 *  all are below the 9e15 that `seed` of a case may be. */
#define CLOD_RUNS_SEEDS_APART INT64_C(1000000000)

typedef struct clod_runs_options {
    const char *program;   ///< path of clod
    int workers;           ///< processes side by side
    const clod_stop *stop; ///< whether to stop all, with checkpoints; or NULL
    void (*tell)(void *context, const char *text);
    void *context;
} clod_runs_options;

typedef enum clod_runs_state {
    CLOD_RUNS_NONE,
    CLOD_RUNS_BEGUN, ///< half done: its folder has a checkpoint, or nothing yet
    CLOD_RUNS_DONE,
    CLOD_RUNS_FAILED
} clod_runs_state;

/** A run: its point, packing and test follow from its place. */
typedef struct clod_runs_row {
    clod_runs_state state;
    double seconds; ///< on the clock, of all pieces so far
    char *why;      ///< owned; of a failed one
    char *settings; ///< owned; seed and parameters that it is made with
} clod_runs_row;

typedef struct clod_runs {
    const clod_plan *plan;
    clod_runs_options options;
    clod_folder *folder; ///< owned
    clod_runs_row *rows; ///< [points][seeds][tests] owned
    size_t points;
    char **cases;        ///< [tests] owned; clod_cases_describe when the calibration began
    int counted_workers; ///< that a budget is counted with
} clod_runs;

/**
 * Open the folder of a calibration, and see that it is of this plan.
 *
 * @return  owned (clod_runs_close), or NULL
 * Errors  CLOD_USAGE: in use, or of another plan, a damaged course.json; CLOD_FAILED: disk, memory.
 * Test    tests/calibrate/test_calibrate.py
 */
clod_runs *clod_runs_open(const clod_plan *plan, const char *directory,
                          const clod_runs_options *options, clod_status *status);

/**
 * See that a folder has no runs of another plan, without opening it; one that is not there has none.
 * Errors  CLOD_USAGE: it has, with the first line of its design.txt that differs; CLOD_FAILED: disk, memory.
 * Test    tests/calibrate/test_calibrate_runs.py
 */
bool clod_runs_look(const clod_plan *plan, const char *directory, clod_status *status);

void clod_runs_close(clod_runs **self);

/** As clod_study_source has it: run what has no row yet, then read the numbers.
 *  Errors  CLOD_USAGE: clod run refuses a run, a case has changed, a damaged file; CLOD_FAILED: a test that
 *          fails with every packing of the first point; disk, memory; CLOD_INTERRUPTED. */
bool clod_runs_compute(void *self, size_t first, size_t count, const double *places,
                       double *results, clod_status *status);

/** As clod_study_source has it: time of the runs of the first `points` over workers and points. */
double clod_runs_seconds(void *self, size_t points);

/** Runs that failed. */
size_t clod_runs_failed(const clod_runs *self);

/** Index of a row, and the point and the test of one. */
size_t clod_runs_row_of(const clod_plan *plan, size_t point, size_t packing, size_t test);
size_t clod_runs_point_of(const clod_plan *plan, size_t row);
size_t clod_runs_test_of(const clod_plan *plan, size_t row);

/** "p003-1-ring": a run's folder with the ending "", a file beside it with its own. */
void clod_runs_name(const clod_plan *plan, size_t row, const char *ending,
                    char name[CLOD_RUNS_NAME]);

/** The same as a path. */
void clod_runs_path(const clod_runs *self, size_t row, const char *ending, char path[PATH_MAX]);

/**
 * Seed of a run. No two runs of a plan have one in common, nor do two tests of one point: with one filling they would scatter
 * together, and targets of different tests count as independent. The first test's are those of a plan that has it alone.
 * Test  tests/calibrate/test_runs_table.c
 */
int64_t clod_runs_seed(const clod_plan *plan, size_t row);

/**
 * What finished runs warn of in their summaries: one warning for each text of a test, with the number of
 * runs that have it. Texts that differ in numbers alone count as one.
 *
 * @param to  [in, out] they are added to it
 * Errors  none.   Threads  safe.   Test  tests/calibrate/test_runs_warnings.c
 */
void clod_runs_warn(const clod_runs *self, clod_warning_list *to);

/**
 * Warn of targets whose runs are consolidated so much more or less than the measured table reaches that
 * they were compared by an extrapolation of it.
 *
 * @param to  [in, out] one warning for each such target is added
 * Errors  none: what cannot be read has been told.   Threads  safe.   Test  tests/calibrate/test_runs_outside.c
 */
void clod_runs_warn_outside(const clod_runs *self, clod_warning_list *to);

/**
 * Warn of targets that count as 0 in some runs, as the strength of a specimen that did not stand: such a run tells no more
 * than that nothing was above 0.
 *
 * @param to  [in, out] one warning for each such target is added
 * Errors  none: what cannot be read has been told.   Threads  safe.   Test  tests/calibrate/test_runs_lacks.c
 */
void clod_runs_warn_zeros(const clod_runs *self, clod_warning_list *to);

#define CLOD_RUNS_REASON 256 ///< bytes of one

/**
 * The first finished run that does not define the number of a target, and why, in the words of its report where that has a line
 * of what the number is of: "p009-1-pile: angle of repose none at the end (2 strips of the flank, 3 are needed)".
 *
 * @param text  [out] "" where there is none
 * @return      whether there is one
 * Errors  none.   Threads  safe.   Test  tests/calibrate/test_runs_lacks.c
 */
bool clod_runs_lacks(const clod_runs *self, size_t target, char text[CLOD_RUNS_REASON]);

/** All rows as CSV, units in the header; owned (clod_memory_free), NULL without memory. */
char *clod_runs_csv(const clod_runs *self, size_t points, const double *places,
                    const double *results);
