/**
 * @file calibrate.c
 * clod calibrate PLAN: parameters of a material from measured targets.
 */

#include <argp.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>

#include "app.h"
#include "calibrate/calibrate.h"
#include "one_case.h"

#if CLOD_GSL

enum { KEY_CHECK = 256 };

typedef struct request {
    clod_one_case of;
    clod_calibrate_options options;
} request;

static atomic_int stop_signal; ///< the first one that came

static void on_signal(int number)
{
    int none = 0;
    atomic_compare_exchange_strong(&stop_signal, &none, number);
}

static const struct argp_option OPTIONS[] = {
    {"output", 'o', "DIR", 0,
     "folder of runs and results (run/NAME for NAME.yaml and for NAME/case.yaml)", 0},
    {"jobs", 'j', "N", 0, "runs side by side (default: one for each processor)", 0},
    {"check", KEY_CHECK, NULL, 0,
     "only check the plan, the tables, the cases at all corners of the ranges and at every "
     "point of the largest design, and that the folder has no runs of another plan; estimate "
     "what a point takes",
     0},
    {"set", 'S', "KEY=VALUE", 0,
     "another value for a key of the plan, e.g. budget=\"2 h\"; may be given often", 0},
    {0},
};

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    char *end;
    long jobs;
    switch (key) {
    case 'o':
        if (argument[0] == '\0') {
            argp_error(state, "--output: the name of a folder is needed");
        }
        self->options.directory = argument;
        return 0;
    case 'j':
        jobs = strtol(argument, &end, 10);
        if (*end != '\0' || jobs < 1 || jobs > 1024) {
            argp_error(state, "--jobs %s: a whole number from 1 to 1024 is needed", argument);
        }
        self->options.workers = (int)jobs;
        return 0;
    case KEY_CHECK:
        self->options.dry = true;
        return 0;
    case ARGP_KEY_ARG:
        if (self->of.path != NULL) {
            argp_error(state, "one plan at a time");
        }
        return clod_one_case_parse(&self->of, key, argument, state);
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "which plan? clod new calibrate writes an example");
        return 0;
    case 'S':
        return clod_one_case_parse(&self->of, key, argument, state);
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void tell(void *context, const char *text)
{
    (void)context;
    fprintf(stderr, "clod: %s\n", text);
}

static void handle(int number)
{
    struct sigaction before;
    struct sigaction action = {.sa_handler = on_signal, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    if (sigaction(number, NULL, &before) == 0 && before.sa_handler != SIG_IGN) {
        sigaction(number, &action, NULL);
    }
}

static int run(request *self)
{
    self->options.program = "/proc/self/exe"; // of the child, too: the same clod, even rebuilt
    self->options.stop = &stop_signal;
    self->options.tell = tell;
    self->options.overrides = self->of.overrides;
    self->options.override_count = self->of.override_count;
    char *report;
    clod_status status = {CLOD_OK, ""};
    const bool good = clod_calibrate_run(self->of.path, &self->options, &report, &status);
    int result = EXIT_SUCCESS;
    if (good && report != NULL && (fputs(report, stdout) == EOF || fflush(stdout) != 0)) {
        fputs(
            "clod calibrate: the results cannot be written to standard output; they are in the "
            "folder\n",
            stderr);
        result = CLOD_FAILED;
    } else if (good && report == NULL) {
        puts("The plan, its cases and tables are in order.");
    } else if (!good) {
        fprintf(stderr, "clod calibrate: %s\n", status.text);
        const int number = atomic_load(&stop_signal);
        result = status.code == CLOD_INTERRUPTED ? 128 + (number != 0 ? number : SIGTERM)
                                                 : (int)status.code;
    }
    clod_calibrate_free(report);
    return result;
}

int clod_app_calibrate(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "PLAN.yaml",
        .doc =
            "Calibrate parameters of a material against laboratory measurements: runs tests at points of "
            "a design, fits surrogates to their results, and tells which parameters the measurements "
            "allow: a material card with intervals.\v"
            "clod new calibrate writes an example; docs/howto/calibrate.md explains its keys. After an "
            "interruption, the same command continues.",
    };
    request self = {0};
    if (!clod_one_case_init(&self.of, &argp, argc, argv, &self)) {
        return CLOD_FAILED;
    }
    handle(SIGINT);
    handle(SIGTERM);
    handle(SIGHUP);
    signal(SIGCHLD, SIG_DFL); // who ignores it gets no end of a process told
    const int result = run(&self);
    free(self.of.overrides);
    return result;
}

#else

int clod_app_calibrate(int argc, char **argv)
{
    (void)argc;
    fprintf(
        stderr,
        "%s: this clod was built without GSL and NLopt. Install the Debian packages libgsl-dev and "
        "libnlopt-dev, and build it again.\n",
        argv[0]);
    return CLOD_FAILED;
}

#endif
