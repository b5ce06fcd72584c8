/**
 * @file runs_warnings.c
 * What the runs of a calibration warn of, counted.
 */

#include <jansson.h>
#include <stdio.h>
#include <string.h>

#include "base/json.h"
#include "base/plural.h"
#include "base/text.h"
#include "calibrate/runs.h"

#define KINDS (CLOD_WARNING_LIST_MOST + 1) // so many that the list says that there are more

/** A warning of a test, and how many of its runs have it. */
typedef struct kind {
    size_t test, runs, first, last; ///< first, last: rows
    char text[CLOD_WARNING_LIST_TEXT];
} kind;

typedef struct counter {
    const clod_plan *plan;
    size_t row; ///< that is looked at
    size_t count;
    kind kinds[KINDS];
} counter;

static void count_text(counter *self, const char *text)
{
    const size_t test = clod_runs_test_of(self->plan, self->row);
    for (size_t k = 0; k < self->count; k++) {
        kind *one = &self->kinds[k];
        if (one->test == test &&
            clod_text_alike(one->text, strlen(one->text), text, strlen(text))) {
            one->runs += one->last == self->row ? 0 : 1;
            one->last = self->row;
            return;
        }
    }
    if (self->count < KINDS) {
        kind *one = &self->kinds[self->count++];
        *one = (kind){.test = test, .runs = 1, .first = self->row, .last = self->row};
        snprintf(one->text, sizeof one->text, "%s", text);
    }
}

/** All lists of warnings in a summary: of the test, and of its evaluation. */
static void count_lists(counter *self, const json_t *in)
{
    const char *key;
    json_t *item;
    size_t k;
    json_object_foreach((json_t *)in, key, item)
    {
        if (strcmp(key, "warnings") != 0) {
            count_lists(self, item);
            continue;
        }
        const json_t *text;
        json_array_foreach(item, k, text)
        {
            if (json_is_string(text)) {
                count_text(self, json_string_value(text));
            }
        }
    }
    json_array_foreach(in, k, item)
    {
        count_lists(self, item);
    }
}

/** False when its summary cannot be read any more. */
static bool count_run(counter *self, const clod_runs *runs, size_t row)
{
    char folder[PATH_MAX];
    clod_status none = {CLOD_OK, ""};
    clod_runs_path(runs, row, "", folder);
    json_t *summary = clod_json_read(folder, "summary.json", &none);
    self->row = row;
    count_lists(self, summary);
    json_decref(summary);
    return summary != NULL;
}

void clod_runs_warn(const clod_runs *self, clod_warning_list *to)
{
    const clod_plan *plan = self->plan;
    counter all = {.plan = plan};
    size_t unread = 0;
    for (size_t row = 0; row < clod_runs_row_of(plan, self->points, 0, 0); row++) {
        if (self->rows[row].state == CLOD_RUNS_DONE) {
            unread += count_run(&all, self, row) ? 0 : 1;
        }
    }
    for (size_t k = 0; k < all.count; k++) {
        const kind *one = &all.kinds[k];
        char name[CLOD_RUNS_NAME];
        clod_runs_name(plan, one->first, "", name);
        clod_warning_list_add(to, "%zu run%s of test %s warn%s, the first of them %s: %s",
                              one->runs, clod_plural((double)one->runs),
                              plan->tests[one->test].name, one->runs == 1 ? "s" : "", name,
                              one->text);
    }
    if (unread > 0) {
        clod_warning_list_add(to,
                              "%zu finished run%s no summary.json that can be read: what %s "
                              "warned of is not known.",
                              unread, unread == 1 ? " has" : "s have",
                              unread == 1 ? "it" : "they");
    }
}
