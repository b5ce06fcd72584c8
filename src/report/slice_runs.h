#pragma once
/**
 * @file slice_runs.h
 * The grid of one field in several runs: which of them can stand side by side, and of which moment.
 */

#include <jansson.h>

#include "report/field_slice.h"
#include "report/run_files.h"

#define CLOD_SLICE_RUNS_MOST 12 ///< runs of a field that are shown

/** A run's grid of the field. */
typedef struct clod_slice_runs_one {
    const clod_run_files *run;
    const char *part;    ///< of a test, whose grid it is; NULL: a free run
    const json_t *grid;  ///< its object in summary.json; NULL: left out
    char why[256];       ///< it is left out
    double end, step;    ///< s: of the run
    json_t *frames;      ///< owned: list of its moments; NULL: none
    const json_t *frame; ///< that is shown; NULL: the mean at the end
    clod_field_slice slice;
} clod_slice_runs_one;

/** A field and the runs. */
typedef struct clod_slice_runs {
    const char *field;
    clod_slice_runs_one *of; ///< [count] borrowed
    size_t count, kept;
    const clod_slice_runs_one *first; ///< that has the field
} clod_slice_runs;

/** What is shown of the runs. */
typedef enum clod_slice_runs_moment {
    CLOD_SLICE_RUNS_SAME_END,   ///< means up to the same end
    CLOD_SLICE_RUNS_SAME_FRAME, ///< the last moment of which all have a frame
    CLOD_SLICE_RUNS_OWN_END,    ///< means, each up to its own end
    CLOD_SLICE_RUNS_PART        ///< of tests: means over the phase with which a part ends
} clod_slice_runs_moment;

/** Find the field in all runs. @param self  with room in `of`   Threads  safe. */
void clod_slice_runs_gather(clod_slice_runs *self, const clod_run_files *runs);

/**
 * Choose what is shown. @param self  two runs or more are kept
 * Errors  CLOD_USAGE: a damaged list of frames.
 */
bool clod_slice_runs_choose(clod_slice_runs *self, clod_slice_runs_moment *chosen,
                            clod_status *status);

/** Read the slices of what was chosen. Errors  CLOD_USAGE: a damaged file; CLOD_FAILED: memory. */
bool clod_slice_runs_read(clod_slice_runs *self, clod_status *status);

/** Free what was read; `of` itself is the caller's. */
void clod_slice_runs_fini(clod_slice_runs *self);
