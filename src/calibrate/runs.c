#include "calibrate/runs.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>

#include "base/clock.h"
#include "base/memory.h"
#include "calibrate/child.h"
#include "calibrate/number.h"
#include "calibrate/rows.h"

#define NAP 20000000  // ns between looks at the processes
#define FIXED 9       // arguments beside the settings
#define PATIENCE 1000 // naps until a folder that an earlier process still writes must be free

size_t clod_runs_row_of(const clod_plan *plan, size_t point, size_t packing, size_t test)
{
    return (point * (size_t)plan->seeds + packing) * plan->test_count + test;
}

/** Point and packing of a row, counted through. */
static size_t packing_of(const clod_plan *plan, size_t row)
{
    return row / plan->test_count;
}

void clod_runs_name(const clod_plan *plan, size_t row, char *text, size_t size)
{
    const size_t seeds = (size_t)plan->seeds;
    const size_t packing = packing_of(plan, row);
    snprintf(text, size, "runs/p%03zu-%zu-%.60s", packing / seeds, packing % seeds + 1,
             plan->tests[row % plan->test_count].name);
}

int64_t clod_runs_seed(const clod_plan *plan, size_t row)
{
    return plan->seed + (int64_t)packing_of(plan, row);
}

static void nap(void)
{
    const struct timespec time = {0, NAP};
    nanosleep(&time, NULL);
}

/** Processes that are running, and what is to be run. */
typedef struct crew {
    clod_runs *runs;
    const double *places;
    clod_child *children; ///< [workers] owned
    size_t *row_of;       ///< [workers] owned
    size_t next, end;     ///< rows still to be started
    size_t done, all;     ///< of those that had none, for people
} crew;

/** Text of a setting, owned; `lost` when there is no memory. */
static char *own(const char *text, bool *lost)
{
    char *copy = clod_memory_text(text);
    *lost = *lost || copy == NULL;
    return copy;
}

static void free_arguments(char **arguments, size_t count)
{
    for (size_t k = 0; k < count && arguments != NULL; k++) {
        clod_memory_free(arguments[k]);
    }
    clod_memory_free(arguments);
}

/** Arguments of `clod run` for a row; owned, NULL without memory. */
static char **make_arguments(const crew *self, size_t row, const char *folder, size_t *count)
{
    const clod_plan *plan = self->runs->plan;
    const size_t d = plan->parameter_count;
    const size_t point = packing_of(plan, row) / (size_t)plan->seeds;
    char **to = clod_memory_alloc(FIXED + 2 * d + 1, sizeof *to);
    *count = FIXED + 2 * d;
    if (to == NULL) {
        return NULL;
    }
    char seed[40];
    snprintf(seed, sizeof seed, "seed=%lld", (long long)clod_runs_seed(plan, row));
    const char *const fixed[FIXED] = {self->runs->options.program,
                                      "run",
                                      plan->tests[row % plan->test_count].path,
                                      "-o",
                                      folder,
                                      "-t",
                                      "1",
                                      "--set",
                                      seed};
    bool lost = false;
    for (size_t k = 0; k < FIXED; k++) {
        to[k] = own(fixed[k], &lost);
    }
    for (size_t k = 0; k < d; k++) {
        to[FIXED + 2 * k] = own("--set", &lost);
        to[FIXED + 2 * k + 1] =
            clod_plan_setting(&plan->parameters[k], self->places[point * d + k]);
        lost = lost || to[FIXED + 2 * k + 1] == NULL;
    }
    if (lost) {
        free_arguments(to, *count);
        return NULL;
    }
    return to;
}

/** A process of an interrupted calibration may still be writing its checkpoint. */
static bool wait_for(const char *folder, clod_status *status)
{
    for (int naps = 0;; naps++) {
        clod_folder *mine = clod_folder_open(folder, status);
        if (mine != NULL) {
            clod_folder_close(&mine);
            return true;
        }
        if (naps == PATIENCE) {
            return false;
        }
        nap();
    }
}

static bool start(crew *self, size_t worker, size_t row, clod_status *status)
{
    char name[128];
    char folder[PATH_MAX];
    char log[PATH_MAX];
    clod_runs_name(self->runs->plan, row, name, sizeof name);
    snprintf(folder, sizeof folder, "%s/%s", self->runs->folder->path, name);
    snprintf(log, sizeof log, "%s/%s.log", self->runs->folder->path, name);
    if (!wait_for(folder, status)) {
        return false;
    }
    size_t count;
    char **arguments = make_arguments(self, row, folder, &count);
    if (arguments == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %s.", name);
    }
    self->row_of[worker] = row;
    const bool good = clod_child_start(&self->children[worker], arguments, log, status);
    free_arguments(arguments, count);
    return good;
}

static bool stopped(const clod_runs *self)
{
    return self->options.stop != NULL && atomic_load(self->options.stop) != 0;
}

static void tell_row(const crew *self, size_t row)
{
    const clod_runs *runs = self->runs;
    const clod_runs_row *of = &runs->rows[row];
    char name[128];
    char text[700];
    clod_runs_name(runs->plan, row, name, sizeof name);
    snprintf(text, sizeof text, "%s %s after %.0f s (%zu of %zu)%s%s", name,
             of->state == CLOD_RUNS_DONE ? "done" : "failed", of->seconds, self->done,
             self->all, of->why != NULL ? ": " : "", of->why != NULL ? of->why : "");
    if (runs->options.tell != NULL) {
        runs->options.tell(runs->options.context, text);
    }
}

/** A run ended: its row, or the end of the calibration when it was no failure of the run itself. */
static bool settle(crew *self, size_t row, int result, double seconds, clod_status *status)
{
    clod_runs *runs = self->runs;
    clod_runs_row *to = &runs->rows[row];
    char name[128];
    clod_runs_name(runs->plan, row, name, sizeof name);
    const int code = WIFEXITED(result) ? WEXITSTATUS(result) : 0;
    if (stopped(runs) || code > 128) {
        return clod_status_fail(status, CLOD_INTERRUPTED,
                                "Interrupted; the same command goes on.");
    }
    if (WIFSIGNALED(result)) {
        return clod_status_fail(
            status, CLOD_FAILED,
            "%s/%s was ended by signal %d, by someone or for want of memory. The same "
            "command goes on.",
            runs->folder->path, name, WTERMSIG(result));
    }
    to->seconds = seconds;
    to->state = code == 0 ? CLOD_RUNS_DONE : CLOD_RUNS_FAILED;
    if (code != 0) {
        to->why = clod_rows_last_words(runs, row);
        if (to->why != NULL && strstr(to->why, strerror(ENOSPC)) != NULL) {
            return clod_status_fail(status, CLOD_FAILED, "%s: %s. The same command goes on.",
                                    name, to->why);
        }
    }
    if (!clod_rows_write(runs, row, status)) {
        return false;
    }
    clod_rows_trim(runs, row);
    self->done++;
    tell_row(self, row);
    return true;
}

/** Give free workers their next rows. */
static bool feed(crew *self, clod_status *status)
{
    for (int w = 0; w < self->runs->options.workers; w++) {
        while (self->next < self->end && self->runs->rows[self->next].state != CLOD_RUNS_NONE) {
            self->next++;
        }
        if (self->children[w].process == 0 && self->next < self->end &&
            !start(self, (size_t)w, self->next++, status)) {
            return false;
        }
    }
    return true;
}

/** Look at each process once; the number still running into `left`. */
static bool collect(crew *self, size_t *left, clod_status *status)
{
    bool good = true;
    *left = 0;
    for (int w = 0; w < self->runs->options.workers; w++) {
        clod_child *child = &self->children[w];
        int result;
        if (child->process != 0 && clod_child_ended(child, &result)) {
            const double seconds = clod_clock_now() - child->began;
            good = (!good || settle(self, self->row_of[w], result, seconds, status)) && good;
        }
        *left += child->process != 0 ? 1 : 0;
    }
    return good;
}

/** Ask all to stop, and wait until they have. */
static void dismiss(crew *self)
{
    for (int w = 0; w < self->runs->options.workers; w++) {
        clod_child_stop(&self->children[w]);
    }
    size_t left = 1;
    while (left > 0) {
        left = 0;
        for (int w = 0; w < self->runs->options.workers; w++) {
            int result;
            clod_child *child = &self->children[w];
            left += child->process != 0 && !clod_child_ended(child, &result) ? 1 : 0;
        }
        nap();
    }
}

static bool work(crew *self, clod_status *status)
{
    size_t left = 1;
    while (left > 0 || self->next < self->end) {
        const bool good =
            !stopped(self->runs) || clod_status_fail(status, CLOD_INTERRUPTED,
                                                     "Interrupted; the same command goes on.");
        if (!good || !feed(self, status) || !collect(self, &left, status)) {
            dismiss(self);
            return false;
        }
        nap();
    }
    return true;
}

/** Rows up to `end`, read from the disk where they are there. */
static bool read_rows(clod_runs *self, size_t points, clod_status *status)
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
        if (!clod_rows_read(self, row, &self->rows[row], status)) {
            return false;
        }
    }
    return true;
}

static bool run_missing(clod_runs *self, size_t first, size_t end, const double *places,
                        clod_status *status)
{
    const size_t workers = (size_t)self->options.workers;
    crew all = {.runs = self,
                .places = places,
                .children = clod_memory_alloc(workers, sizeof *all.children),
                .row_of = clod_memory_alloc(workers, sizeof *all.row_of),
                .next = first,
                .end = end};
    for (size_t row = first; row < end; row++) {
        all.all += self->rows[row].state == CLOD_RUNS_NONE ? 1 : 0;
    }
    const bool good =
        (all.children != NULL && all.row_of != NULL) ||
        clod_status_fail(status, CLOD_FAILED, "No memory for %zu processes.", workers);
    const bool done = good && (all.all == 0 || work(&all, status));
    clod_memory_free(all.children);
    clod_memory_free(all.row_of);
    return done;
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

/** Numbers of one packing of a point. */
static bool read_numbers(const clod_runs *self, size_t packing, double *results,
                         clod_status *status)
{
    const clod_plan *plan = self->plan;
    for (size_t t = 0; t < plan->target_count; t++) {
        const size_t row = packing * plan->test_count + plan->targets[t].test;
        results[t] = (double)NAN;
        if (self->rows[row].state == CLOD_RUNS_DONE) {
            char name[128];
            char folder[PATH_MAX];
            clod_runs_name(plan, row, name, sizeof name);
            snprintf(folder, sizeof folder, "%s/%s", self->folder->path, name);
            if (!clod_number_read(plan, &plan->targets[t], folder, &results[t], status)) {
                return false;
            }
        }
    }
    return true;
}

bool clod_runs_compute(void *context, size_t first, size_t count, const double *places,
                       double *results, clod_status *status)
{
    clod_runs *self = context;
    const size_t seeds = (size_t)self->plan->seeds;
    if (!read_rows(self, first + count, status) ||
        !run_missing(self, clod_runs_row_of(self->plan, first, 0, 0),
                     clod_runs_row_of(self->plan, first + count, 0, 0), places, status) ||
        (first == 0 && !check_first(self, status))) {
        return false;
    }
    for (size_t packing = first * seeds; packing < (first + count) * seeds; packing++) {
        if (!read_numbers(self, packing, results + packing * self->plan->target_count,
                          status)) {
            return false;
        }
    }
    return true;
}

double clod_runs_seconds(void *context, size_t points)
{
    const clod_runs *self = context;
    double sum = 0.0;
    for (size_t row = 0; row < clod_runs_row_of(self->plan, points, 0, 0); row++) {
        sum += self->rows[row].seconds;
    }
    return sum / self->options.workers / (double)points;
}

size_t clod_runs_failed(const clod_runs *self)
{
    size_t failed = 0;
    for (size_t row = 0; row < clod_runs_row_of(self->plan, self->points, 0, 0); row++) {
        failed += self->rows[row].state == CLOD_RUNS_FAILED ? 1 : 0;
    }
    return failed;
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
    snprintf(inside, sizeof inside, "%s/runs", directory);
    self->folder = clod_folder_open(directory, status);
    if (self->folder == NULL || !clod_folder_make(inside, status) ||
        !clod_rows_mark(self, status)) {
        clod_runs_close(&self);
    }
    return self;
}

void clod_runs_close(clod_runs **self)
{
    if (self == NULL || *self == NULL) {
        return;
    }
    const size_t rows = clod_runs_row_of((*self)->plan, (*self)->points, 0, 0);
    for (size_t row = 0; row < rows; row++) {
        clod_memory_free((*self)->rows[row].why);
    }
    clod_memory_free((*self)->rows);
    clod_folder_close(&(*self)->folder);
    clod_memory_free(*self);
    *self = NULL;
}
