/**
 * @file hopper.c
 * clod hopper CASE: mass-flow angle and critical outlet from what was measured.
 */

#include <argp.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app.h"
#include "clod/hopper.h"
#include "clod/text_file.h"
#include "one_case.h"
#include "report/report.h"

enum { KEY_JSON = 256 };

typedef struct request {
    clod_one_case of;
    const char *output;
    bool json;
} request;

static const struct argp_option OPTIONS[] = {
    {"json", KEY_JSON, NULL, 0, "print everything as JSON in place of the table", 0},
    {"output", 'o', "NAME", 0,
     "also write NAME.json, the design chart NAME.svg and the page NAME.html, which replace files of "
     "these names, and the page's figures NAME-FIGURE.svg",
     0},
    {"set", 'S', "KEY=VALUE", 0, "another value for a key, e.g. cone.outlet=200mm", 0},
    {0},
};

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    switch (key) {
    case KEY_JSON:
        self->json = true;
        return 0;
    case 'o':
        if (argument[0] == '\0' || argument[strlen(argument) - 1] == '/') {
            argp_error(state, "-o \"%s\" has no name; give one, e.g. -o design", argument);
        }
        self->output = argument;
        return 0;
    default:
        return clod_one_case_parse(&self->of, key, argument, state);
    }
}

/** Owned name of a file: NAME with an ending. */
static char *name_of(const request *self, const char *ending)
{
    const size_t size = strlen(self->output) + strlen(ending) + 1;
    char *path = malloc(size);
    if (path != NULL) {
        snprintf(path, size, "%s%s", self->output, ending);
    }
    return path;
}

/** Write one text into NAME with an ending, say so, and free the text. */
static bool put(const request *self, const char *ending, char *text, clod_status *status)
{
    char *path = name_of(self, ending);
    bool done = path != NULL && text != NULL;
    if (done) {
        done = clod_text_file_write(path, self->of.path, text, status);
        if (done) {
            fprintf(self->json ? stderr : stdout, "wrote %s\n", path);
        }
    } else {
        clod_status_fail(status, CLOD_FAILED, "No memory for the result.");
    }
    clod_hopper_free(text);
    free(path);
    return done;
}

/** Write the page: first, since it may be refused. */
static bool put_page(const request *self, const clod_hopper *hopper, size_t *figures,
                     clod_status *status)
{
    char *path = name_of(self, ".html");
    const bool done = path != NULL
                          ? clod_report_hopper(hopper, path, figures, status)
                          : clod_status_fail(status, CLOD_FAILED, "No memory for the page.");
    free(path);
    return done;
}

/** Say that the page is written with its figures, and on standard error what it lacks, if anything. */
static void tell_page(const request *self, size_t figures)
{
    FILE *out = self->json ? stderr : stdout;
    fprintf(out, "wrote %s.html\n", self->output);
    fprintf(out, "wrote %s-FIGURE.svg, the page's %zu figures\n", self->output, figures);
    if (clod_report_lacks() != NULL) {
        fprintf(stderr, "clod hopper: %s.\n", clod_report_lacks());
    }
}

/** Write all files that belong to a name. */
static bool put_files(const request *self, const clod_hopper *hopper, clod_status *status)
{
    size_t figures = 0;
    const bool done = put_page(self, hopper, &figures, status) &&
                      put(self, ".json", clod_hopper_json(hopper), status) &&
                      put(self, ".svg", clod_hopper_chart(hopper), status);
    if (done) {
        tell_page(self, figures);
    }
    return done;
}

/** Print the table or the JSON. */
static bool print(const request *self, const clod_hopper *hopper, clod_status *status)
{
    char *text = self->json ? clod_hopper_json(hopper) : clod_hopper_table(hopper);
    bool done = text != NULL;
    if (!done) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the result.");
    } else if (fputs(text, stdout) < 0 || (self->json && fputs("\n", stdout) < 0) ||
               fflush(stdout) != 0) {
        done = clod_status_fail(status, CLOD_FAILED, "Cannot write the result: %s.",
                                strerror(errno));
    }
    clod_hopper_free(text);
    return done;
}

static bool run(const request *self, clod_status *status)
{
    clod_hopper *hopper =
        clod_hopper_create(self->of.path, self->of.overrides, self->of.override_count, status);
    if (hopper == NULL) {
        return false;
    }
    const bool done = print(self, hopper, status) &&
                      (self->output == NULL || put_files(self, hopper, status));
    clod_hopper_destroy(&hopper);
    return done;
}

int clod_app_hopper(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "CASE.yaml",
        .doc =
            "Design a hopper from flow function, wall friction and bulk density, measured or "
            "simulated: half angle for mass flow, critical outlet, rathole, each with an "
            "interval.\v"
            "clod new hopper writes an example; docs/howto/hopper.md explains its keys.",
    };
    request self = {.of.example = "clod new hopper"};
    if (!clod_one_case_init(&self.of, &argp, argc, argv, &self)) {
        return CLOD_FAILED;
    }
    clod_status status = {CLOD_OK, ""};
    const bool good = run(&self, &status);
    return clod_one_case_fini(&self.of, argv, good, &status);
}
