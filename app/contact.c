/**
 * @file contact.c
 * clod contact CASE: drive one contact along a path and print what the law does.
 */

#include <argp.h>
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app.h"
#include "clod/contact_bench.h"
#include "clod/text_file.h"
#include "one_case.h"

typedef struct request {
    clod_one_case of;
    const char *output; ///< NULL: standard output
    bool summary;       ///< only the summary
} request;

static const struct argp_option OPTIONS[] = {
    {"output", 'o', "FILE", 0, "write the table to FILE instead of standard output", 0},
    {"summary", 's', NULL, 0, "print only the summary, to standard output", 0},
    CLOD_ONE_CASE_SET,
    {0},
};

static error_t parse(int key, char *argument, struct argp_state *state)
{
    request *self = state->input;
    switch (key) {
    case 'o':
        self->output = argument;
        return 0;
    case 's':
        self->summary = true;
        return 0;
    default:
        return clod_one_case_parse(&self->of, key, argument, state);
    }
}

static bool print_row(void *context, const clod_contact_bench_row *row, clod_status *status)
{
    FILE *out = context;
    if (out == NULL) {
        return true;
    }
    char line[CLOD_CONTACT_BENCH_LINE];
    clod_contact_bench_line(row, line);
    return fprintf(out, "%s\n", line) > 0 ||
           clod_status_fail(status, CLOD_FAILED, "the table cannot be written: %s",
                            strerror(errno));
}

static void print_summary(FILE *out, const clod_contact_bench_summary *s)
{
    const double overlap = s->d_before > 0.0 ? s->d_min / s->d_before : 0.0;
    const double force = s->f_before > 0.0 ? fabs(s->f_min) / s->f_before : 0.0;
    fprintf(out, "                              this path    closed form\n");
    fprintf(out, "largest force             %11.6g N\n", s->f_max);
    fprintf(out, "  at overlap              %11.6g m\n", s->d_max);
    fprintf(out, "largest pull              %11.6g N\n", fabs(s->f_min));
    fprintf(out, "  at overlap              %11.6g m\n", s->d_min);
    fprintf(out, "d_min / d_max             %11.6f      %11.6f\n", overlap,
            s->pull_off_overlap);
    fprintf(out, "|f_min| / f_max           %11.6f      %11.6f\n", force, s->pull_off_force);
    fprintf(out, "restitution, law alone                     %11.6f%s\n", s->restitution_law,
            s->restitution_law > 0.0 ? "" : "  (does not part)");
    fprintf(out, "  dash-pot alone, as asked                 %11.6f\n", s->restitution_asked);
    fprintf(out, "  both, a computed impact                  %9.4f%s\n", s->restitution_both,
            s->restitution_both > 0.0 ? "" : "  (does not part)");
    fprintf(out, "damping ratio                              %11.6f\n", s->damping_ratio);
    fprintf(out, "gamma_n at the largest force               %11.6g N s/m\n",
            s->damping_coefficient);
}

static bool run(const clod_case *from, FILE *table, clod_contact_bench_summary *summary,
                clod_status *status)
{
    if (table != NULL && fprintf(table, "%s\n", clod_contact_bench_header()) < 0) {
        return clod_status_fail(status, CLOD_FAILED, "the table cannot be written: %s",
                                strerror(errno));
    }
    if (!clod_contact_bench_run(from, print_row, table, summary, status)) {
        return false;
    }
    if (table != NULL && (fflush(table) != 0 || ferror(table))) {
        return clod_status_fail(status, CLOD_FAILED, "the table cannot be written: %s",
                                strerror(errno));
    }
    return true;
}

/** The table as a whole, then into its file: half a table is never there. Memory may end: each
 *  print is looked at, and fclose leaves no text. */
static bool run_into_file(const request *self, const clod_case *from,
                          clod_contact_bench_summary *summary, clod_status *status)
{
    char *text = NULL;
    size_t size = 0;
    FILE *table = open_memstream(&text, &size);
    bool good = table != NULL && run(from, table, summary, status);
    const bool closed = table != NULL && fclose(table) == 0;
    if (table == NULL || (good && (!closed || text == NULL))) {
        good = clod_status_fail(status, CLOD_FAILED, "no memory for the table");
    }
    good = good && clod_text_file_write(self->output, self->of.path, text, status);
    free(text);
    return good;
}

static bool work(const request *self, clod_status *status)
{
    clod_contact_bench_summary summary;
    clod_case *from = clod_one_case_load(&self->of, status);
    if (from == NULL) {
        return false;
    }
    bool good = clod_case_has(from, CLOD_CASE_CONTACT_BENCH) ||
                clod_status_fail(status, CLOD_USAGE,
                                 "%s: there is no contact_bench in this case; clod new "
                                 "contact-bench writes an example",
                                 self->of.path);
    if (good && self->output != NULL) {
        good = run_into_file(self, from, &summary, status);
    } else if (good) {
        good = run(from, self->summary ? NULL : stdout, &summary, status);
    }
    if (good) {
        print_summary(self->summary ? stdout : stderr, &summary);
    }
    clod_case_destroy(&from);
    return good;
}

int clod_app_contact(int argc, char **argv)
{
    const struct argp argp = {
        .options = OPTIONS,
        .parser = parse,
        .args_doc = "CASE",
        .doc =
            "Drive one contact along the path of contact_bench in CASE with the contact law of "
            "the simulations. Print a table (CSV, units in the header) to standard output, and "
            "a summary with the closed forms to standard error."
            "\vThe duration of a leg sets its speed, and the speed sets the damping forces. On "
            "slow legs (the default, 1 s) damping is negligible. The branch is loading (f1), "
            "unloading (f2), adhesive (f3) or open, as in eq. (4). The restitutions do not "
            "depend on the impact speed.",
    };
    clod_status status = {CLOD_OK, ""};
    request self = {.of = {.example = "clod new contact-bench"}};
    if (!clod_one_case_init(&self.of, &argp, argc, argv, &self)) {
        return CLOD_FAILED;
    }
    const bool good = work(&self, &status);
    return clod_one_case_fini(&self.of, argv, good, &status);
}
