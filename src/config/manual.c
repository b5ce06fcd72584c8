/**
 * @file manual.c
 * The manual of all keys, from the parameter tables.
 */

#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "config/param.h"
#include "config/testers.h"
#include "config/walk.h"

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
                        : clod_param_default_text(param));
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

static const char HEAD[] =
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
static const char TESTERS[] = "),\n"
                              "  or contact_bench, which may also stand beside one of "
                              "the others.\n";

static void case_head(FILE *out)
{
    char testers[CLOD_CONFIG_TESTER_KEYS];
    clod_config_tester_keys(testers);
    fprintf(out, "%s%s%s", HEAD, testers, TESTERS);
}

const clod_schema *clod_schema_case(void)
{
    static const clod_schema OF_CASE = {.keys = "Keys of a case file",
                                        .top = "The case",
                                        .verb = "run",
                                        .table = &CLOD_TABLE_CASE,
                                        .head = case_head};
    return &OF_CASE;
}

char *clod_schema_manual(const clod_schema *const *schemas)
{
    const clod_schema *const cases[] = {clod_schema_case(), NULL};
    schemas = schemas != NULL ? schemas : cases;
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    for (size_t k = 0; schemas[k] != NULL; k++) {
        fprintf(out, "%s# %s\n\n", k == 0 ? "" : "\n", schemas[k]->keys);
        schemas[k]->head(out);
        manual_table(out, schemas[k]->top, schemas[k]->table);
        clod_walk(schemas[k]->table, manual_group, out);
    }
    return clod_text_close(&text);
}
