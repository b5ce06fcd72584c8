#include "calibrate/crew.h"

#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>

#include "base/clock.h"
#include "base/memory.h"
#include "calibrate/cases.h"
#include "calibrate/child.h"
#include "calibrate/rows.h"

#define NAP 20000000  // ns between looks at the processes
#define FIXED 10      // arguments beside the settings
#define PATIENCE 1000 // naps until a folder that an earlier process still writes must be free

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
    size_t done, all;     ///< of those that had not ended, for people
} crew;

static bool has_ended(const clod_runs_row *row)
{
    return row->state == CLOD_RUNS_DONE || row->state == CLOD_RUNS_FAILED;
}

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
    const size_t point = clod_runs_point_of(plan, row);
    const clod_plan_test *test = &plan->tests[clod_runs_test_of(plan, row)];
    clod_plan_settings settings;
    bool lost = !clod_plan_settings_at(plan, test, self->places + point * plan->parameter_count,
                                       &settings);
    char **to = clod_memory_alloc(FIXED + 2 * settings.count + 1, sizeof *to);
    *count = FIXED + 2 * settings.count;
    if (to == NULL) {
        clod_plan_settings_fini(&settings);
        return NULL;
    }
    char seed[40];
    snprintf(seed, sizeof seed, "seed=%lld", (long long)clod_runs_seed(plan, row));
    const char *const fixed[FIXED] = {self->runs->options.program,
                                      "run",
                                      test->path,
                                      "-o",
                                      folder,
                                      "-t",
                                      "1",
                                      "--no-report",
                                      "--set",
                                      seed};
    for (size_t k = 0; k < FIXED; k++) {
        to[k] = own(fixed[k], &lost);
    }
    for (size_t k = 0; k < settings.count; k++) {
        to[FIXED + 2 * k] = own("--set", &lost);
        to[FIXED + 2 * k + 1] = own(settings.items[k], &lost);
    }
    clod_plan_settings_fini(&settings);
    if (lost) {
        free_arguments(to, *count);
        return NULL;
    }
    return to;
}

/** A process of an interrupted calibration may still be writing its checkpoint. */
static bool wait_until_free(const crew *self, const char *folder, clod_status *status)
{
    for (int naps = 0; naps < PATIENCE && clod_rows_in_use(folder); naps++) {
        if (clod_stop_asked(self->runs->options.stop)) {
            return clod_stop_fail(status);
        }
        nap();
    }
    return true;
}

static bool start(crew *self, size_t worker, size_t row, clod_status *status)
{
    const clod_runs *runs = self->runs;
    char folder[PATH_MAX];
    char log[PATH_MAX];
    clod_runs_path(runs, row, "", folder);
    clod_runs_path(runs, row, ".log", log);
    if (!wait_until_free(self, folder, status) ||
        !clod_cases_same(runs, clod_runs_test_of(runs->plan, row), status) ||
        !clod_rows_begin(runs, row, status)) {
        return false;
    }
    size_t count;
    char **arguments = make_arguments(self, row, folder, &count);
    if (arguments == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %s.", folder);
    }
    self->row_of[worker] = row;
    const bool good = clod_child_start(&self->children[worker], arguments, log, status);
    free_arguments(arguments, count);
    return good;
}

static void tell_row(const crew *self, size_t row)
{
    const clod_runs *runs = self->runs;
    const clod_runs_row *of = &runs->rows[row];
    char name[CLOD_RUNS_NAME];
    char text[700];
    clod_runs_name(runs->plan, row, "", name);
    snprintf(text, sizeof text, CLOD_RUNS_FOLDER "/%s %s after %.0f s (%zu of %zu)%s%s", name,
             of->state == CLOD_RUNS_DONE ? "done" : "failed", of->seconds, self->done,
             self->all, of->why != NULL ? ": " : "", of->why != NULL ? of->why : "");
    if (runs->options.tell != NULL) {
        runs->options.tell(runs->options.context, text);
    }
}

/** Whether a process ended by a fault of its own, and not by someone or for want of memory. */
static bool crashed(int result)
{
    const int number = WIFSIGNALED(result) ? WTERMSIG(result) : 0;
    return number == SIGSEGV || number == SIGABRT || number == SIGFPE || number == SIGBUS ||
           number == SIGILL;
}

/** Ends that are none of the run itself: they end the calibration. */
static bool check_end(const clod_runs *runs, size_t row, int result, clod_status *status)
{
    char path[PATH_MAX];
    clod_runs_path(runs, row, "", path);
    const int code = result != CLOD_CHILD_LOST && WIFEXITED(result) ? WEXITSTATUS(result) : 0;
    if (clod_stop_asked(runs->options.stop) || code > 128) {
        return clod_stop_fail(status);
    }
    if (result == CLOD_CHILD_LOST) {
        return clod_status_fail(status, CLOD_FAILED,
                                "%s: it cannot be told how its process ended. The same "
                                "command goes on.",
                                path);
    }
    if (WIFSIGNALED(result) && !crashed(result)) {
        return clod_status_fail(
            status, CLOD_FAILED,
            "%s was ended by signal %d, by someone or for want of memory. The same "
            "command goes on.",
            path, WTERMSIG(result));
    }
    if (code == CLOD_USAGE) {
        char *words = clod_rows_last_words(runs, row);
        clod_status_fail(status, CLOD_USAGE,
                         "clod run refuses %s, and the calibration ends: %s", path,
                         words != NULL ? words : "");
        clod_memory_free(words);
        return false;
    }
    return true;
}

/** Why a run failed; owned, NULL without memory. */
static char *reason(const clod_runs *runs, size_t row, int result)
{
    if (!WIFSIGNALED(result)) {
        return clod_rows_last_words(runs, row);
    }
    char text[80];
    snprintf(text, sizeof text, "clod crashed with signal %d (%.40s)", WTERMSIG(result),
             strsignal(WTERMSIG(result)));
    return clod_memory_text(text);
}

/** A run ended: its row, or the end of the calibration when it was no failure of the run itself. */
static bool settle(crew *self, size_t row, int result, double seconds, clod_status *status)
{
    clod_runs *runs = self->runs;
    clod_runs_row *to = &runs->rows[row];
    if (!check_end(runs, row, result, status)) {
        return false;
    }
    if (!clod_cases_same(runs, clod_runs_test_of(runs->plan, row), status)) {
        clod_rows_forget(runs, row); // nobody knows which case it has read
        return false;
    }
    const bool done = WIFEXITED(result) && WEXITSTATUS(result) == 0;
    to->why = done ? NULL : reason(runs, row, result);
    if (to->why != NULL && strstr(to->why, strerror(ENOSPC)) != NULL) {
        return clod_status_fail(status, CLOD_FAILED, "%s. The same command goes on.", to->why);
    }
    to->seconds += seconds;
    to->state = done ? CLOD_RUNS_DONE : CLOD_RUNS_FAILED;
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
        while (self->next < self->end && has_ended(&self->runs->rows[self->next])) {
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
            good = good && settle(self, self->row_of[w], result, seconds, status);
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
        const bool good = !clod_stop_asked(self->runs->options.stop) || clod_stop_fail(status);
        if (!good || !feed(self, status) || !collect(self, &left, status)) {
            dismiss(self);
            return false;
        }
        nap();
    }
    return true;
}

bool clod_crew_run(clod_runs *runs, size_t first, size_t end, const double *places,
                   clod_status *status)
{
    const size_t workers = (size_t)runs->options.workers;
    crew all = {.runs = runs,
                .places = places,
                .children = clod_memory_alloc(workers, sizeof *all.children),
                .row_of = clod_memory_alloc(workers, sizeof *all.row_of),
                .next = first,
                .end = end};
    for (size_t row = first; row < end; row++) {
        all.all += has_ended(&runs->rows[row]) ? 0 : 1;
    }
    const bool good =
        (all.children != NULL && all.row_of != NULL) ||
        clod_status_fail(status, CLOD_FAILED, "No memory for %zu processes.", workers);
    const bool done = good && (all.all == 0 || work(&all, status));
    clod_memory_free(all.children);
    clod_memory_free(all.row_of);
    return done;
}
