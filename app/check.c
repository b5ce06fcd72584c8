/**
 * @file check.c
 * clod check CASE: step, overlap, inertial number and cost of a case, without running it.
 */

#include <argp.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app.h"
#include "clod/check.h"
#include "one_case.h"

#define KEY_JSON 0x100
#define KEY_RANKS 0x101
#define TEXT(x) #x
#define NUMBER(x) TEXT(x)

typedef struct request {
    clod_one_case of;
    bool json;
    clod_check_options options;
} request;

static const struct argp_option OPTIONS[] = {
    {"output", 'o', "DIR", 0,
     "results folder of the run: the free space of its disk is checked", 0},
    {"threads", 't', "N", 0, "threads of the run (default: as clod run chooses)", 0},
    {"ranks", KEY_RANKS, "R", 0,
     "also memory and time of so many ranks under mpirun, each with --threads N (default: 1)",
     0},
    CLOD_ONE_CASE_SET,
    {"json", KEY_JSON, NULL, 0, "print one JSON object instead of text", 0},
    {0},
};

static void set_threads(request *self, const char *argument, struct argp_state *state)
{
    char *end;
    const long threads = strtol(argument, &end, 10);
    if (*argument == '\0' || *end != '\0' || threads < 1 || threads > 4096) {
        argp_error(state, "--threads %s: a whole number from 1 to 4096", argument);
    }
    self->options.threads = (int)threads;
}

static void set_ranks(request *self, const char *argument, struct argp_state *state)
{
    char *end;
    const long ranks = strtol(argument, &end, 10);
    if (*argument == '\0' || *end != '\0' || ranks < 1 || ranks > CLOD_CHECK_RANKS) {
        argp_error(state, "--ranks %s: a whole number from 1 to " NUMBER(CLOD_CHECK_RANKS),
                   argument);
    }
    self->options.ranks = (int)ranks;
}

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    switch (key) {
    case 'o':
        self->options.directory = argument;
        return 0;
    case 't':
        set_threads(self, argument, state);
        return 0;
    case KEY_RANKS:
        set_ranks(self, argument, state);
        return 0;
    case KEY_JSON:
        self->json = true;
        return 0;
    default:
        return clod_one_case_parse(&self->of, key, argument, state);
    }
}

static bool work(const request *self, clod_status *status)
{
    clod_case *from = clod_one_case_load(&self->of, status);
    if (from == NULL) {
        return false;
    }
    clod_check_report report;
    char *text = malloc(CLOD_CHECK_TEXT);
    bool good = text != NULL || clod_status_fail(status, CLOD_FAILED, "out of memory");
    good = good && clod_check_report_make(from, &self->options, &report, status);
    if (good && self->json) {
        good = clod_check_report_json(&report, text) ||
               clod_status_fail(status, CLOD_FAILED, "out of memory");
    } else if (good) {
        clod_check_report_text(&report, text);
    }
    if (good && (printf("%s%s", text, self->json ? "\n" : "") < 0 || fflush(stdout) != 0)) {
        good = clod_status_fail(status, CLOD_FAILED, "the report cannot be written: %s",
                                strerror(errno));
    }
    free(text);
    clod_case_destroy(&from);
    return good;
}

int clod_app_check(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "CASE",
        .doc =
            "Check CASE; print time step, overlap, inertial number, and the run time, memory "
            "and disk space that the run will need. The check inserts the grains, simulates "
            "the first 100 steps, and times the step on a small packing of its own. It writes "
            "no files."
            "\vThe overlap is that of two mean grains under the target stress. The Bond number "
            "is the largest adhesive force of a contact after that stress, over the weight of "
            "a mean grain. The inertial number I = (shear rate) d sqrt(density/stress) should "
            "be about 1e-3 or below. Cohesive specimens settle to a larger height than "
            "fill_fraction gives, and I is then lower. \"Likely\" times are those of copper "
            "ore; \"at most\" follows from the limits in the case. Exit status: 0 for a valid "
            "case, with or without warnings; 2 for an invalid one; 1 when the first steps "
            "fail. Of a case with more than 300000 grains the check inserts only a sample and "
            "simulates no steps; a note says so. What ranks cost is by the model of docs/scaling.md, "
            "with the rate measured here.",
    };
    clod_status status = {CLOD_OK, ""};
    request self = {.of = {.example = "clod new"}};
    if (!clod_one_case_init(&self.of, &argp, argc, argv, &self)) {
        return CLOD_FAILED;
    }
    const bool good = work(&self, &status);
    return clod_one_case_fini(&self.of, argv, good, &status);
}
