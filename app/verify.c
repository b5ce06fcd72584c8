/**
 * @file verify.c
 * clod verify [NAME ...]: run the verification suite and report what it found.
 */

#include <argp.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app.h"
#include "arguments.h"
#include "join.h"
#include "verify/verify.h"

typedef struct request {
    const char *directory;
    const char **names;
    size_t name_count;
    bool list;
    bool slow;
    clod_ranks *ranks; ///< borrowed
} request;

enum { KEY_SLOW = 256 };

static const struct argp_option OPTIONS[] = {
    {"output", 'o', "DIR", 0, "folder for the report, curves and cases (run/verify)", 0},
    {"list", 'l', NULL, 0, "list the tests", 0},
    {"slow", KEY_SLOW, NULL, 0, "run the slow tests of bulk solids; they write validation.md",
     0},
    {0},
};

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    switch (key) {
    case 'o':
        if (argument[0] == '\0') {
            argp_error(state, "--output: the name of a folder is needed");
        }
        self->directory = argument;
        return 0;
    case 'l':
        self->list = true;
        return 0;
    case KEY_SLOW:
        self->slow = true;
        return 0;
    case ARGP_KEY_ARG:
        self->names[self->name_count++] = argument;
        return 0;
    default:
        return ARGP_ERR_UNKNOWN;
    }
}

static void print_list(void)
{
    for (size_t k = 0; k < clod_verify_count(); k++) {
        printf("%-18s %s%s\n", clod_verify_name(k), clod_verify_help(k),
               clod_verify_is_slow(k) ? " (slow)" : "");
    }
}

static void show_progress(void *context, const char *name)
{
    (void)context;
    fprintf(stderr, "clod verify: %s\n", name);
}

/** The misses, recorded or not, and how many there are. */
static void print_report(const clod_verify_report *report, const char *directory)
{
    for (size_t r = 0; r < report->count; r++) {
        const clod_verify_row *row = &report->rows[r];
        const bool recorded = row->known[0] != '\0';
        if (!row->passed || recorded) {
            printf("%s %s: %s: expected %.9g, got %.9g, tolerance %.3g%s%s%s\n",
                   !recorded     ? "MISS"
                   : row->passed ? "MISS (passes, but recorded as a miss)"
                                 : "recorded miss",
                   row->test, row->quantity, row->expected, row->got, row->tolerance,
                   row->relative ? " of it" : "", recorded ? "; " : "", row->known);
        }
    }
    printf("%zu quantities, %zu missed; %zu recorded misses; %s/%s has all of them\n",
           report->count, report->misses, report->known, directory,
           clod_verify_report_name(report->slow));
}

/** Exit status that says whether the report may be written: none is there, or clod wrote it. */
static int check_report(const char *directory, bool slow)
{
    static const char MARK[] = "\n\nWritten by `clod verify";
    char path[4096];
    char text[128] = "";
    snprintf(path, sizeof path, "%s/%s", directory, clod_verify_report_name(slow));
    FILE *file = fopen(path, "r");
    if (file == NULL && (errno == ENOENT || errno == ENOTDIR)) {
        return EXIT_SUCCESS; // it is not there; what cannot be written is told at the end
    }
    bool readable = file != NULL;
    if (readable) {
        text[fread(text, 1, sizeof text - 1, file)] = '\0';
        readable = ferror(file) == 0;
    }
    if (!readable) {
        fprintf(stderr, "clod verify: %s: cannot be read: %s\n", path, strerror(errno));
    } else if (strstr(text, MARK) == NULL) {
        fprintf(stderr,
                "clod verify: %s is in the way: clod did not write it. Choose another folder "
                "with -o, or move the file away.\n",
                path);
    }
    if (file != NULL) {
        fclose(file);
    }
    return !readable ? CLOD_FAILED : strstr(text, MARK) == NULL ? CLOD_USAGE : EXIT_SUCCESS;
}

static int run(const request *self)
{
    const clod_verify_options options = {.directory = self->directory,
                                         .names = self->names,
                                         .name_count = self->name_count,
                                         .slow = self->slow,
                                         .ranks = self->ranks,
                                         .progress = show_progress};
    clod_verify_report report;
    clod_status status = {CLOD_OK, ""};
    int result = check_report(self->directory, self->slow);
    if (result != EXIT_SUCCESS) {
        return result;
    }
    if (!clod_verify_run(&options, &report, &status)) {
        fprintf(stderr, "clod verify: %s\n", status.text);
        result = (int)status.code;
    } else {
        print_report(&report, self->directory);
        result = report.misses > 0 ? EXIT_FAILURE : EXIT_SUCCESS;
    }
    clod_verify_fini(&report);
    return result;
}

int clod_app_verify(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "[NAME ...]",
        .doc =
            "Run the verification suite, or only the tests NAME: small cases whose result is "
            "known from a closed form or from the literature. With --slow, run whole beds of "
            "grains and compare them with laws of bulk solids; this takes long.\v"
            "The run writes to DIR: verification.md (with --slow validation.md) with every "
            "quantity, expected and obtained; a CSV file of each curve; and the cases, which "
            "clod run can run too. Exit status: 0 when every quantity is within its tolerance, "
            "else 1. A recorded miss is a known deviation, with its reason in the report; it "
            "fails the suite only when it passes. Under mpirun the processes share the whole shear, "
            "wall friction and uniaxial tests of --slow; everything else is done by one of them.",
    };
    int failed;
    clod_ranks *ranks = clod_app_join("clod verify", &failed);
    if (ranks == NULL) {
        return failed;
    }
    request self = {.directory = "run/verify",
                    .ranks = ranks,
                    .names = calloc((size_t)argc, sizeof(char *))};
    if (self.names == NULL) {
        fputs("clod verify: no memory\n", stderr);
        return 1;
    }
    if (!clod_arguments_parse(&argp, argc, argv, 0, &self)) {
        free(self.names);
        return CLOD_FAILED;
    }
    int result = EXIT_SUCCESS;
    if (self.list) {
        print_list();
    } else {
        result = run(&self);
    }
    free(self.names);
    return result;
}
