/**
 * @file explain.c
 * `clod explain` and the manual, from the parameter tables.
 */

#include <stdio.h>
#include <string.h>

#include "base/given.h"
#include "base/memory.h"
#include "base/text.h"
#include "clod/schema.h"
#include "config/suggest.h"
#include "config/testers.h"
#include "config/walk.h"

/** What is looked for, and where the answer goes. */
typedef struct search {
    FILE *out;
    const char *key;
    size_t found;
    bool whole_paths; ///< compare whole paths; else only the last step
    clod_suggest near;
    char best[CLOD_WALK_PATH]; ///< path behind near.best
} search;

static bool is_any(const char *step, size_t length)
{
    return (length == 1 && strncmp(step, "N", 1) == 0) ||
           (length == 4 && (strncmp(step, "NAME", 4) == 0 || strncmp(step, "PAIR", 4) == 0));
}

/** Whether a user's path is a table's path; N, NAME, PAIR stand for one step or none. */
static bool matches(const char *path, const char *key)
{
    if (*path == '\0' || *key == '\0') {
        return *path == *key;
    }
    const size_t own = strcspn(path, ".");
    const size_t theirs = strcspn(key, ".");
    const char *path_rest = path + own + (path[own] == '.');
    const char *key_rest = key + theirs + (key[theirs] == '.');
    if (is_any(path, own)) {
        return matches(path_rest, key) || matches(path_rest, key_rest);
    }
    return own == theirs && strncmp(path, key, own) == 0 && matches(path_rest, key_rest);
}

static const char *default_of(const clod_param *param)
{
    if (param->fallback != NULL) {
        return param->fallback;
    }
    return param->need == CLOD_PARAM_REQUIRED ? "none: must be given" : "none: may be left out";
}

static void print_row(FILE *out, const char *path, const clod_param *param)
{
    char text[512];
    fprintf(out, "%s\n  %s\n", path, clod_param_help(param, text, sizeof text));
    fprintf(out, "  kind     %s\n", clod_param_kind_text(param, text, sizeof text));
    if (clod_param_range_text(param, text, sizeof text)[0] != '\0') {
        fprintf(out, "  allowed  %s\n", text);
    }
    if (!clod_param_is_group(param)) {
        fprintf(out, "  default  %s\n", default_of(param));
    }
    if (param->example != NULL) {
        fprintf(out, "  example  %s: %s\n", param->key, param->example);
    }
    fprintf(out, "  source   %s\n", param->source);
    const clod_table *tables[] = {param->beside, param->table};
    const char *before = "  keys\n    ";
    for (size_t t = 0; t < sizeof tables / sizeof tables[0]; t++) {
        for (size_t i = 0; tables[t] != NULL && i < tables[t]->count; i++) {
            const clod_param *row = &tables[t]->params[i];
            fprintf(out, "%s%-18s  %s\n", before, row->key,
                    clod_param_help(row, text, sizeof text));
            before = "    ";
        }
    }
}

static void look(void *context, const char *path, const clod_param *param)
{
    search *self = context;
    const bool hit =
        self->whole_paths ? matches(path, self->key) : strcmp(param->key, self->key) == 0;
    if (hit) {
        fputs(self->found == 0 ? "" : "\n", self->out);
        print_row(self->out, path, param);
        self->found++;
    }
    const char *before = self->near.best;
    const size_t distance = self->near.distance;
    clod_suggest_offer(&self->near, self->whole_paths ? path : param->key);
    if (self->near.distance < distance) {
        snprintf(self->best, sizeof self->best, "%s", self->near.best);
        self->near.best = self->best;
    } else {
        self->near.best = before;
    }
}

static void list_row(void *context, const char *path, const clod_param *param)
{
    char text[512];
    const char *help = clod_param_help(param, text, sizeof text);
    if (!clod_param_is_group(param)) {
        fprintf(context, "  %-42s %s\n", path, help);
    } else {
        fprintf(context, "%s: %s\n", path, help);
    }
}

static char *explain_all(void)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fputs(
        "Keys of a case file. N is the number of an element, from 0; NAME is a name of yours;\n"
        "PAIR is default, or two materials a-b. clod explain KEY tells more.\n\n",
        out);
    clod_walk(&CLOD_TABLE_CASE, list_row, out);
    return clod_text_close(&text);
}

char *clod_schema_explain(const char *key, clod_status *status)
{
    CLOD_NEED(status);
    if (key == NULL) {
        char *all = explain_all();
        if (all == NULL) {
            clod_status_fail(status, CLOD_FAILED, "out of memory");
        }
        return all;
    }
    clod_text text;
    search self = {.out = clod_text_open(&text), .key = key};
    if (self.out == NULL) {
        clod_status_fail(status, CLOD_FAILED, "out of memory");
        return NULL;
    }
    self.near = clod_suggest_start(key);
    self.whole_paths = true;
    clod_walk(&CLOD_TABLE_CASE, look, &self);
    if (self.found == 0) {
        self.whole_paths = false;
        clod_walk(&CLOD_TABLE_CASE, look, &self);
    }
    char *answer = clod_text_close(&text);
    if (self.found == 0) {
        char hint[CLOD_WALK_PATH + 32];
        clod_status_fail(status, CLOD_USAGE,
                         "there is no key %s%s\nclod explain lists all keys", key,
                         clod_suggest_text(&self.near, hint, sizeof hint));
        clod_schema_free(answer);
        return NULL;
    }
    if (answer == NULL) {
        clod_status_fail(status, CLOD_FAILED, "out of memory");
    }
    return answer;
}

/** A `|` would end the cell of a Markdown table, `<` would begin a tag. */
static void print_cell(FILE *out, const char *text)
{
    fputs(" ", out);
    for (; *text != '\0'; text++) {
        fprintf(out, *text == '|' ? "\\%c" : "%c", *text);
    }
    fputs(" |", out);
}

static void manual_row(FILE *out, const clod_param *param)
{
    char text[512];
    fprintf(out, "| `%s` |", param->key);
    print_cell(out, clod_param_kind_text(param, text, sizeof text));
    print_cell(out, clod_param_is_group(param)
                        ? (param->need == CLOD_PARAM_REQUIRED ? "must be given" : "-")
                        : default_of(param));
    print_cell(out, clod_param_range_text(param, text, sizeof text));
    print_cell(out, param->example != NULL ? param->example : "");
    print_cell(out, clod_param_help(param, text, sizeof text));
    print_cell(out, param->source);
    fputc('\n', out);
}

static void manual_table(FILE *out, const char *path, const clod_table *table)
{
    fprintf(out, "\n## %s\n\n%s\n\n", path, table->title);
    fputs("| key | kind | default | allowed | example | meaning | source |\n"
          "|---|---|---|---|---|---|---|\n",
          out);
    for (size_t i = 0; i < table->count; i++) {
        manual_row(out, &table->params[i]);
    }
}

static void manual_group(void *context, const char *path, const clod_param *param)
{
    if (param->table == NULL) {
        return;
    }
    if (param->beside != NULL) {
        manual_table(context, path, param->beside);
    }
    const char *step = clod_walk_step(param);
    char title[CLOD_WALK_PATH + 8];
    snprintf(title, sizeof title, "%s%s%s", path, step == NULL ? "" : ".",
             step == NULL ? "" : step);
    manual_table(context, title, param->table);
}

static const char MANUAL_HEAD[] =
    "# Keys of a case file\n\n"
    "This page is written by `clod explain --manual` from the tables that also load a case.\n\n"
    "- A case file is YAML 1.2 (JSON is YAML too), at most 1 MiB, without anchors and tags.\n"
    "- Every quantity carries its unit: `54.8 kPa`, `6.35 mm`, `20 rpm`, `250 kg`. A bare "
    "number\n"
    "  is an error, but 0 needs no unit. Pure numbers take none, or `%`.\n"
    "- Exponents of units are whole: `kg/m3`, `m/s2`, `N*m`, `kg m-3`. A contact stiffness is\n"
    "  written with the exponent of its contact: `4.75e8 N/m^1.5`.\n"
    "- Vectors are lists, `[0 mm, 0 mm, 35 mm]`, or a text with one unit, `0 0 35 mm`.\n"
    "- In paths, N is the number of an element of a list, from 0; NAME is a name of yours; "
    "PAIR\n"
    "  is `default` or two materials `a-b`. `--set grains.0.count=500` changes a value for "
    "one\n"
    "  run.\n"
    "- A case has grains, walls and stages (a free run), or one tester (";
static const char MANUAL_TESTERS[] = "),\n"
                                     "  or contact_bench, which may also stand beside one of "
                                     "the others.\n";

char *clod_schema_manual(void)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    char testers[CLOD_CONFIG_TESTER_KEYS];
    clod_config_tester_keys(testers);
    fprintf(out, "%s%s%s", MANUAL_HEAD, testers, MANUAL_TESTERS);
    manual_table(out, "The case", &CLOD_TABLE_CASE);
    clod_walk(&CLOD_TABLE_CASE, manual_group, out);
    return clod_text_close(&text);
}

void clod_schema_free(char *text)
{
    clod_memory_free(text);
}
