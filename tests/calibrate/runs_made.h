#pragma once
/**
 * @file runs_made.h
 * A calibration of one point whose runs have ended, for tests that write what they told.
 */

#include <sys/stat.h>

#include "calibrate/runs.h"
#include "plan_lab.h"

#define RUNS_MADE_MOST 3 ///< packings

typedef struct runs_made {
    clod_plan plan;
    clod_folder folder;
    clod_runs_row rows[RUNS_MADE_MOST];
    clod_runs runs;
} runs_made;

/** @param packings  of the point, RUNS_MADE_MOST at most @param target  as lab_load_good takes it */
static inline void runs_make(runs_made *self, void **state, const char *from, size_t packings,
                             const char *target)
{
    char path[PATH_MAX];
    *self = (runs_made){.folder = {.path = *state}};
    lab_load_good(state, from, target, &self->plan);
    self->plan.seeds = (int64_t)packings;
    for (size_t k = 0; k < packings; k++) {
        self->rows[k].state = CLOD_RUNS_DONE;
    }
    self->runs = (clod_runs){
        .plan = &self->plan, .folder = &self->folder, .rows = self->rows, .points = 1};
    (void)mkdir(temp_path(path, state, "runs"), 0777); // there in the second of a test
}

static inline void runs_write(const runs_made *self, size_t row, const char *name,
                              const char *text)
{
    char path[PATH_MAX];
    clod_runs_path(&self->runs, row, "", path);
    (void)mkdir(path, 0777);
    clod_runs_path(&self->runs, row, name, path);
    FILE *out = fopen(path, "w");
    assert_non_null(out);
    fputs(text, out);
    assert_int_equal(fclose(out), 0);
}
