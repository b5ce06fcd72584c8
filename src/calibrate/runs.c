#include "calibrate/runs.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "calibrate/cases.h"
#include "calibrate/course.h"
#include "calibrate/crew.h"
#include "calibrate/number.h"
#include "calibrate/rows.h"

size_t clod_runs_row_of(const clod_plan *plan, size_t point, size_t packing, size_t test)
{
    return (point * (size_t)plan->seeds + packing) * plan->test_count + test;
}

size_t clod_runs_test_of(const clod_plan *plan, size_t row)
{
    return row % plan->test_count;
}

/** Point and packing of a row, counted through. */
static size_t packing_of(const clod_plan *plan, size_t row)
{
    return row / plan->test_count;
}

size_t clod_runs_point_of(const clod_plan *plan, size_t row)
{
    return packing_of(plan, row) / (size_t)plan->seeds;
}

void clod_runs_name(const clod_plan *plan, size_t row, const char *ending,
                    char name[CLOD_RUNS_NAME])
{
    snprintf(name, CLOD_RUNS_NAME, "p%03zu-%zu-%.60s%s", clod_runs_point_of(plan, row),
             packing_of(plan, row) % (size_t)plan->seeds + 1,
             plan->tests[clod_runs_test_of(plan, row)].name, ending);
}

void clod_runs_path(const clod_runs *self, size_t row, const char *ending, char path[PATH_MAX])
{
    char name[CLOD_RUNS_NAME];
    clod_runs_name(self->plan, row, ending, name);
    snprintf(path, PATH_MAX, "%s/" CLOD_RUNS_FOLDER "/%s", self->folder->path, name);
}

int64_t clod_runs_seed(const clod_plan *plan, size_t row)
{
    return plan->seed + (int64_t)packing_of(plan, row) +
           CLOD_RUNS_SEEDS_APART * (int64_t)clod_runs_test_of(plan, row);
}

/** Rows up to `end`, read from the disk where they are there. */
static bool read_rows(clod_runs *self, size_t points, const double *places, clod_status *status)
{
    const size_t before = clod_runs_row_of(self->plan, self->points, 0, 0);
    const size_t after = clod_runs_row_of(self->plan, points, 0, 0);
    if (after <= before) {
        return true;
    }
    clod_runs_row *grown = clod_memory_grow(self->rows, before, after, sizeof *grown);
    if (grown == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %zu runs.", after);
    }
    self->rows = grown;
    self->points = points;
    for (size_t row = before; row < after; row++) {
        clod_runs_row *to = &self->rows[row];
        to->settings = clod_rows_settings(self->plan, row, places);
        if (to->settings == NULL) {
            return clod_status_fail(status, CLOD_FAILED, "No memory for %zu runs.", after);
        }
        if (!clod_rows_read(self, row, to, status)) {
            return false;
        }
    }
    return true;
}

/** A test none of whose packings of the first point gives a result will not in others. */
static bool check_first(const clod_runs *self, clod_status *status)
{
    for (size_t t = 0; t < self->plan->test_count; t++) {
        size_t failed = 0;
        for (size_t s = 0; s < (size_t)self->plan->seeds; s++) {
            failed +=
                self->rows[clod_runs_row_of(self->plan, 0, s, t)].state == CLOD_RUNS_FAILED ? 1
                                                                                            : 0;
        }
        if (failed == (size_t)self->plan->seeds) {
            const clod_runs_row *row = &self->rows[clod_runs_row_of(self->plan, 0, 0, t)];
            return clod_status_fail(
                status, CLOD_FAILED,
                "Test %s fails in the middle of all ranges. Mend the case or the ranges, and remove "
                "%s. It said: %s",
                self->plan->tests[t].name, self->folder->path,
                row->why != NULL ? row->why : "nothing");
        }
    }
    return true;
}

/** A finished run whose results have been damaged: say how it is done again. */
static bool fail_damaged(const char *folder, clod_status *status)
{
    const clod_status first = *status;
    return clod_status_fail(status, first.code,
                            "%.600s. If its files are damaged, remove %s.json and %s, and the "
                            "run is done again.",
                            first.text, folder, folder);
}

/** Numbers of one packing of a point. */
static bool read_numbers(const clod_runs *self, size_t packing, double *results,
                         clod_status *status)
{
    const clod_plan *plan = self->plan;
    for (size_t t = 0; t < plan->target_count; t++) {
        results[t] = (double)NAN;
    }
    for (size_t test = 0; test < plan->test_count; test++) {
        const size_t row = packing * plan->test_count + test;
        char folder[PATH_MAX];
        clod_runs_path(self, row, "", folder);
        if (self->rows[row].state == CLOD_RUNS_DONE &&
            !clod_number_read(plan, test, folder, results, NULL, status)) {
            return fail_damaged(folder, status);
        }
    }
    return true;
}

/** Numbers of points [first, first + count). */
static bool read_points(const clod_runs *self, size_t first, size_t count, double *results,
                        clod_status *status)
{
    const size_t seeds = (size_t)self->plan->seeds;
    for (size_t packing = first * seeds; packing < (first + count) * seeds; packing++) {
        if (!read_numbers(self, packing, results + packing * self->plan->target_count,
                          status)) {
            return false;
        }
    }
    return true;
}

bool clod_runs_compute(void *context, size_t first, size_t count, const double *places,
                       double *results, clod_status *status)
{
    clod_runs *self = context;
    if (!read_rows(self, first + count, places, status) ||
        // beyond the first point: the budget has been found large enough
        (first > 0 && self->plan->budget > 0.0 && !clod_course_write(self, status))) {
        return false;
    }
    if (!clod_crew_run(self, clod_runs_row_of(self->plan, first, 0, 0),
                       clod_runs_row_of(self->plan, first + count, 0, 0), places, status)) {
        clod_status second; // the first failure is told; runs.csv has what is there
        (void)read_points(self, first, count, results, &second);
        return false;
    }
    return (first > 0 || check_first(self, status)) &&
           read_points(self, first, count, results, status);
}

double clod_runs_seconds(void *context, size_t points)
{
    const clod_runs *self = context;
    double sum = 0.0;
    for (size_t row = 0; row < clod_runs_row_of(self->plan, points, 0, 0); row++) {
        sum += self->rows[row].seconds;
    }
    return sum / self->counted_workers / (double)points;
}

size_t clod_runs_failed(const clod_runs *self)
{
    size_t failed = 0;
    for (size_t row = 0; row < clod_runs_row_of(self->plan, self->points, 0, 0); row++) {
        failed += self->rows[row].state == CLOD_RUNS_FAILED ? 1 : 0;
    }
    return failed;
}

/** Cases as they are when the calibration begins. */
static bool keep_cases(clod_runs *self, clod_status *status)
{
    self->cases = clod_memory_alloc(self->plan->test_count, sizeof *self->cases);
    if (self->cases == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the cases.");
    }
    for (size_t t = 0; t < self->plan->test_count; t++) {
        self->cases[t] = clod_cases_describe(self->plan, t, status);
        if (self->cases[t] == NULL) {
            return false;
        }
    }
    return true;
}

clod_runs *clod_runs_open(const clod_plan *plan, const char *directory,
                          const clod_runs_options *options, clod_status *status)
{
    clod_runs *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the runs.");
        return NULL;
    }
    *self = (clod_runs){.plan = plan, .options = *options};
    char inside[PATH_MAX];
    snprintf(inside, sizeof inside, "%s/" CLOD_RUNS_FOLDER, directory);
    self->folder = clod_folder_open(directory, status);
    if (self->folder == NULL || !clod_folder_make(inside, status) ||
        !keep_cases(self, status) || !clod_rows_mark(self, status) ||
        !clod_course_read(self, status)) {
        clod_runs_close(&self);
    }
    return self;
}

bool clod_runs_look(const clod_plan *plan, const char *directory, clod_status *status)
{
    clod_runs *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the runs.");
    }
    *self = (clod_runs){.plan = plan};
    const bool good = keep_cases(self, status) && clod_rows_look(self, directory, status);
    clod_runs_close(&self);
    return good;
}

void clod_runs_close(clod_runs **self)
{
    if (self == NULL || *self == NULL) {
        return;
    }
    const size_t rows = clod_runs_row_of((*self)->plan, (*self)->points, 0, 0);
    for (size_t row = 0; row < rows; row++) {
        clod_memory_free((*self)->rows[row].why);
        clod_memory_free((*self)->rows[row].settings);
    }
    for (size_t t = 0; t < (*self)->plan->test_count && (*self)->cases != NULL; t++) {
        clod_memory_free((*self)->cases[t]);
    }
    clod_memory_free((*self)->cases);
    clod_memory_free((*self)->rows);
    clod_folder_close(&(*self)->folder);
    clod_memory_free(*self);
    *self = NULL;
}
