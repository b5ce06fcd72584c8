/**
 * @file run.c
 * clod run CASE: run a case to its end, or go on with one that was interrupted.
 */

#include <argp.h>
#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "app.h"
#include "clod/run.h"
#include "duration.h"
#include "join.h"
#include "one_case.h"
#include "report/report.h"

#define LOG_INTERVAL 10.0 ///< s between plain lines when standard error is not a terminal

typedef struct request {
    clod_one_case of;
    clod_run_options options;
    bool no_page; ///< leave out the page that a complete run gets
} request;

enum { KEY_NO_REPORT = 256 };

/** What the progress line shows; parts report from their own threads. */
typedef struct screen {
    pthread_mutex_t lock;
    bool terminal;
    double last; ///< s, when a plain line was last written
} screen;

// Lock-free atomics, so safe in the handler; the threads of all parts read stop_signal.
static atomic_int stop_signal;   ///< the first one that came
static atomic_int save_requests; ///< SIGUSR1 that have come
static atomic_bool on_terminal;  ///< a progress line is to be overwritten

#define CLEAR_LINE "\r\033[K"

/** Ask the run to stop; does only what a signal handler may do. */
static void on_signal(int number)
{
    static const char TEXT[] =
        CLEAR_LINE "clod: stopping after a checkpoint; again to stop at once\n";
    int none = 0;
    atomic_compare_exchange_strong(&stop_signal, &none, number);
    if (number == SIGINT) {
        const int error = errno;
        const size_t skip = atomic_load(&on_terminal) ? 0 : sizeof CLEAR_LINE - 1;
        const ssize_t told = write(STDERR_FILENO, TEXT + skip, sizeof TEXT - 1 - skip);
        (void)told; // nobody is there to be told
        errno = error;
    }
}

/** Ask the run to write its state and to go on. */
static void on_save(int number)
{
    (void)number;
    atomic_fetch_add(&save_requests, 1);
}

static void handle(int number, void (*handler)(int), int flags)
{
    struct sigaction action = {.sa_handler = handler, .sa_flags = SA_RESTART | flags};
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, NULL);
}

/** Stop with a checkpoint on the signals of people, batch systems and closed terminals. */
static void handle_signals(void)
{
    struct sigaction hang_up;
    handle(SIGINT, on_signal,
           (int)SA_RESETHAND); // the second one ends the program, as people expect
    handle(SIGTERM, on_signal,
           0); // no end at the second: it is often sent to the process and its group
    if (sigaction(SIGHUP, NULL, &hang_up) == 0 && hang_up.sa_handler != SIG_IGN) {
        handle(SIGHUP, on_signal, 0); // as SIGTERM; under nohup it stays ignored
    }
    handle(SIGUSR1, on_save, 0);
    signal(SIGPIPE, SIG_IGN); // who reads the progress may end before the checkpoint is written
    signal(SIGXFSZ, SIG_IGN); // a file at its size limit is an error of its writer, with a text
}

static const struct argp_option OPTIONS[] = {
    {"output", 'o', "DIR", 0, "results folder (run/NAME for NAME.yaml and for NAME/case.yaml)",
     0},
    {"threads", 't', "N", 0,
     "number of threads, at most one per processor (default: all processors, but at least "
     "500 grains per thread). Results do not depend on it",
     0},
    {"set", 'S', "KEY=VALUE", 0,
     "change a key of the case, for instance ring_shear.speed='10 mm/s'; repeat for more keys",
     0},
    {"fresh", 'f', NULL, 0, "remove earlier results in the folder and start over", 0},
    {"from", 'F', "DIR[@SECONDS]", 0,
     "start from the grains and contact histories of another run: of a free run from its last "
     "checkpoint, or the one that SIGUSR1 wrote at SECONDS; of a test from its finished "
     "preparation",
     0},
    {"time-limit", 'T', "DURATION", 0,
     "stop with a checkpoint before this time is over, counted from the start of the program, "
     "as after SIGTERM (exit status 143): 90 s, 30 min, 24 h, 1 d, or 1-12:00:00 as batch "
     "systems write it",
     0},
    {"simd", 'i', "SET", 0,
     "instruction set: scalar, avx2, avx512, neon (this machine's best); results do not depend "
     "on it",
     0},
    {"no-report", KEY_NO_REPORT, NULL, 0,
     "leave out report.html and its figures, the page for the browser that clod report writes "
     "too",
     0},
    {0},
};

static int read_threads(const char *text, const struct argp_state *state)
{
    char *end;
    const long threads = strtol(text, &end, 10);
    if (*end != '\0' || threads < 1 || threads > 1024) {
        argp_error(state, "--threads %s: a whole number from 1 to 1024 is needed", text);
    }
    return (int)threads;
}

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    switch (key) {
    case 'o':
        if (argument[0] == '\0') {
            argp_error(state, "--output: the name of a folder is needed");
        }
        self->options.directory = argument;
        return 0;
    case 't':
        self->options.threads = read_threads(argument, state);
        return 0;
    case 'f':
        self->options.fresh = true;
        return 0;
    case 'F':
        if (argument[0] == '\0') {
            argp_error(state, "--from: the results folder of another run is needed");
        }
        self->options.from = argument;
        return 0;
    case 'T':
        if (!clod_duration_read(argument, &self->options.time_limit)) {
            argp_error(state,
                       "--time-limit %s: a time above 0 is needed, as 90 s, 30 min, 24 h, 1 d "
                       "or 1-12:00:00",
                       argument);
        }
        return 0;
    case 'i':
        self->options.simd = argument;
        return 0;
    case KEY_NO_REPORT:
        self->no_page = true;
        return 0;
    default:
        return clod_one_case_parse(&self->of, key, argument, state);
    }
}

static double clock_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void write_remaining(char text[80], double remaining)
{
    text[0] = '\0';
    if (remaining >= 0.0) {
        const long s = (long)remaining;
        snprintf(text, 80, ", at most %ld:%02ld:%02ld left of this part", s / 3600, s / 60 % 60,
                 s % 60);
    }
}

static void show_progress(void *context, const clod_progress *now)
{
    screen *self = context;
    pthread_mutex_lock(&self->lock);
    const double clock = clock_now();
    if (self->terminal || now->finished || clock - self->last > LOG_INTERVAL) {
        char remaining[80];
        write_remaining(remaining, now->finished ? -1.0 : now->remaining);
        fprintf(stderr, "%s%-16s %-12s %8.4f s, step %lld, %.3g grain-steps/s%s%s",
                self->terminal ? CLEAR_LINE : "", now->part, now->phase, now->time,
                (long long)now->step, now->grain_steps_per_s, remaining,
                self->terminal && !now->finished ? "" : "\n");
        fflush(stderr);
        self->last = clock;
    }
    pthread_mutex_unlock(&self->lock);
}

static void show_notice(void *context, const char *text)
{
    screen *self = context;
    pthread_mutex_lock(&self->lock);
    fprintf(stderr, "%sclod: %s\n", self->terminal ? CLEAR_LINE : "", text);
    pthread_mutex_unlock(&self->lock);
}

static int exit_status(const clod_status *status)
{
    if (status->code == CLOD_INTERRUPTED) {
        const int number = atomic_load(&stop_signal);  // none: at the time limit
        return 128 + (number != 0 ? number : SIGTERM); // 130 after SIGINT, 143, 129 SIGHUP
    }
    return status->code == CLOD_USAGE ? 2 : 1;
}

/** Where the page of a run goes. */
typedef struct run_page {
    char *standard;     ///< owned; NULL: the folder was named
    const char *folder; ///< NULL: no memory for it
    bool there;         ///< the run was complete before, and has a page: it stays, with what
                        ///< clod report has laid over it
} run_page;

static bool has_file(const char *folder, const char *name)
{
    char path[4096];
    struct stat about;
    return snprintf(path, sizeof path, "%s/%s", folder, name) < (int)sizeof path &&
           stat(path, &about) == 0 && S_ISREG(about.st_mode);
}

/** Look for a page before the run. */
static run_page find_page(const request *self)
{
    clod_status status = {CLOD_OK, ""}; // a folder without a name is told by the run
    run_page page = {.folder = self->options.directory};
    if (page.folder == NULL) {
        page.folder = page.standard = clod_report_folder(self->of.path, &status);
    }
    page.there = page.folder != NULL && !self->options.fresh &&
                 has_file(page.folder, "report.txt") && has_file(page.folder, "report.html");
    return page;
}

/** Remove a page that somebody had made while the run went on: it says that the run is not complete. */
static void drop_page(const run_page *page)
{
    char path[4096];
    if (!page->there && page->folder != NULL &&
        snprintf(path, sizeof path, "%s/report.html", page->folder) < (int)sizeof path) {
        (void)unlink(path); // none is the rule
    }
}

/** What the page lacks. */
static void say_damage(const char *text)
{
    fprintf(stderr, "clod: %s\n", text);
}

/** Write the page of a run that is complete. The run is done, so what fails here is only said. */
static void write_page(const run_page *page)
{
    clod_status status = {CLOD_FAILED, "no memory for the name of its folder"};
    const clod_report_options options = {
        .runs = &page->folder, .run_count = 1, .tell = say_damage};
    char *path = NULL;
    if (page->there) {
        fprintf(stderr, "clod: the page of this run stays as it is: %s/report.html\n",
                page->folder);
        return;
    }
    if (page->folder == NULL || !clod_report_write(&options, &path, &status)) {
        fprintf(stderr,
                "clod run: the run is complete and its results are safe, but its page "
                "report.html could not be written (clod report writes it, too): %s\n",
                status.text);
        drop_page(page);
        return;
    }
    fprintf(stderr, "clod: figures and tables for the browser: %s\n", path);
    if (clod_report_lacks() != NULL) {
        fprintf(stderr, "clod: %s.\n", clod_report_lacks());
    }
    clod_report_free(path);
}

static int run_case(request *self)
{
    screen shown = {.terminal = isatty(STDERR_FILENO) != 0, .last = -LOG_INTERVAL};
    atomic_store(&on_terminal, shown.terminal);
    clod_status status = {0};
    clod_case *from = clod_one_case_load(&self->of, &status);
    if (from == NULL) {
        fprintf(stderr, "clod run: %s\n", status.text);
        return exit_status(&status);
    }
    pthread_mutex_init(&shown.lock, NULL);
    self->options.stop = &stop_signal;
    self->options.save = &save_requests;
    self->options.progress = show_progress;
    self->options.notice = show_notice;
    self->options.context = &shown;
    const run_page page = find_page(self);
    char *report;
    bool ok = clod_run(from, &self->options, &report, &status);
    const bool complete = ok;
    if (ok && (fputs(report, stdout) == EOF || fflush(stdout) != 0)) {
        fputs("clod run: the results cannot be written to standard output; they are in the "
              "results "
              "folder\n",
              stderr);
        ok = false;
    } else if (!ok) {
        fprintf(stderr, "%sclod run: %s\n", shown.terminal ? CLEAR_LINE : "", status.text);
    }
    if (complete && self->no_page) {
        drop_page(&page);
    } else if (complete) {
        write_page(&page);
    }
    clod_run_free(report);
    clod_report_free(page.standard);
    clod_case_destroy(&from);
    pthread_mutex_destroy(&shown.lock);
    return ok ? 0 : exit_status(&status);
}

int clod_app_run(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "CASE",
        .doc =
            "Run a case file: a free run, a ring shear or Jenike shear test up to the yield "
            "locus, a uniaxial test up to the flow function, or a wall friction test up to "
            "the wall yield locus.\v"
            "After an interruption, the same command continues from the last checkpoint. "
            "Ctrl-C, SIGTERM and SIGHUP stop the run with a checkpoint (exit status 130, 143 "
            "and 129); a second Ctrl-C stops it at once, without one. On SIGUSR1 the run "
            "writes "
            "a snapshot and a permanent checkpoint of each active part, and continues. The "
            "results folder holds results and log; the result table also goes to standard "
            "output. A complete run has a page for the browser there, report.html "
            "(docs/howto/report.md). mpirun -n N clod run CASE computes it on N processes, with the same bits.",
    };
    int failed;
    clod_ranks *ranks = clod_app_join("clod run", &failed);
    if (ranks == NULL) {
        return failed;
    }
    request self = {.of.example = "clod new ring-shear", .options.ranks = ranks};
    if (!clod_one_case_init(&self.of, &argp, argc, argv, &self)) {
        return CLOD_FAILED;
    }
    handle_signals();
    const int result = run_case(&self);
    free(self.of.overrides);
    return result;
}
