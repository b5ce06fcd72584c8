/**
 * @file report.c
 * clod report RUN... and clod compare RUN...: results folders as pages for the browser.
 */

#include "report/report.h"

#include <argp.h>
#include <stdio.h>
#include <stdlib.h>

#include "app.h"
#include "arguments.h"

enum { KEY_LAB = 256 };

typedef struct request {
    clod_report_options options;
    const char **runs; ///< owned
} request;

static const struct argp_option OPTIONS[] = {
    {"lab", KEY_LAB, "FILE.csv", 0,
     "measured shear points, or wall friction over a wall test, to lay over, with the columns that clod locus reads",
     0},
    {"output", 'o', "FILE.html", 0, NULL, 0},
    {0},
};

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    switch (key) {
    case KEY_LAB:
        self->options.lab = argument;
        return 0;
    case 'o':
        self->options.output = argument;
        return 0;
    case ARGP_KEY_ARG:
        self->runs[self->options.run_count++] = argument;
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "which run? Name its results folder, e.g. run/first");
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

/** Say on standard error what the pages lack, if anything. */
static void say_lacks(const char *verb)
{
    if (clod_report_lacks() != NULL) {
        fprintf(stderr, "%s: %s.\n", verb, clod_report_lacks());
    }
}

/** What a run lacks, of which the page is made all the same. */
static void say_damage(const char *text)
{
    fprintf(stderr, "clod: %s\n", text);
}

/** Warnings and results of several runs. */
static void show_results(const char *text)
{
    printf("%s\nCurves, and what differs between the cases:\n", text);
}

/** Write one page and print its name; the exit status. */
static int write_page(const char *verb, const clod_report_options *options,
                      bool (*write)(const clod_report_options *, char **, clod_status *))
{
    clod_status status = {CLOD_OK, ""};
    char *path;
    if (!write(options, &path, &status)) {
        fprintf(stderr, "%s: %s\n", verb, status.text);
        return (int)status.code;
    }
    printf("%s\n", path);
    clod_report_free(path);
    return EXIT_SUCCESS;
}

static bool read_request(request *self, const struct argp *argp, int argc, char **argv)
{
    self->runs = calloc((size_t)argc, sizeof *self->runs);
    if (self->runs == NULL) {
        fprintf(stderr, "%s: no memory\n", argv[0]);
        return false;
    }
    self->options.runs = self->runs;
    return clod_arguments_parse(argp, argc, argv, 0, self);
}

int clod_app_report(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "RUN...",
        .doc =
            "Write report.html into each results folder RUN: one file that a browser shows "
            "without a network, with warnings, results, curves, tables and a 3-D view of the last "
            "snapshot; and each figure beside it as SVG. RUN may be the folder of a calibration "
            "too: parameters, targets, surrogates. -o names another file for the page of one "
            "run. clod hopper -o writes the page of a hopper's design.\vdocs/howto/report.md has examples.",
    };
    request self = {.options = {.tell = say_damage}};
    int result = CLOD_FAILED;
    if (read_request(&self, &argp, argc, argv)) {
        result = EXIT_SUCCESS;
        if (self.options.output != NULL && self.options.run_count > 1) {
            fputs(
                "clod report: -o names one page, and there are several runs; clod compare puts "
                "them on one page\n",
                stderr);
            result = CLOD_USAGE;
        }
        for (size_t k = 0; result == EXIT_SUCCESS && k < self.options.run_count; k++) {
            clod_report_options one = self.options;
            one.runs = &self.runs[k];
            one.run_count = 1;
            result = write_page(argv[0], &one, clod_report_write);
        }
        say_lacks(argv[0]);
    }
    free(self.runs);
    return result;
}

int clod_app_compare(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "RUN...",
        .doc =
            "Write compare.html, or the file that -o names, about the results folders RUN, of "
            "runs of one kind, not of calibrations: tables "
            "of their results and of the keys in which their cases differ, curves over "
            "each other; and each figure beside it as SVG. Print warnings and results, and the "
            "name of the page in the last line.\v"
            "docs/howto/report.md has examples.",
    };
    request self = {.options = {.tell = say_damage, .show = show_results}};
    int result = CLOD_FAILED;
    if (read_request(&self, &argp, argc, argv)) {
        result = write_page(argv[0], &self.options, clod_report_compare);
        say_lacks(argv[0]);
    }
    free(self.runs);
    return result;
}
