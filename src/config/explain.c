/**
 * @file explain.c
 * `clod explain`, from the parameter tables.
 */

#include <stdio.h>
#include <string.h>

#include "base/given.h"
#include "base/memory.h"
#include "base/text.h"
#include "config/suggest.h"
#include "config/walk.h"

/** What is looked for, and where the answer goes. */
typedef struct search {
    FILE *out;
    const clod_schema *schema;
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

static void print_row(FILE *out, const clod_schema *schema, const char *path,
                      const clod_param *param)
{
    char text[512];
    fputs(path, out);
    if (schema->name != NULL) {
        fprintf(out, ", %s", schema->name);
    }
    fprintf(out, "\n  %s\n", clod_param_help(param, text, sizeof text));
    fprintf(out, "  kind     %s\n", clod_param_kind_text(param, text, sizeof text));
    if (clod_param_range_text(param, text, sizeof text)[0] != '\0') {
        fprintf(out, "  allowed  %s\n", text);
    }
    if (!clod_param_is_group(param)) {
        fprintf(out, "  default  %s\n", clod_param_default_text(param));
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
        print_row(self->out, self->schema, path, param);
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

static char *explain_all(const clod_schema *const *schemas, clod_status *status)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    for (size_t k = 0; out != NULL && schemas[k] != NULL; k++) {
        fprintf(out, "%s%s.", k == 0 ? "" : "\n", schemas[k]->keys);
        fputs(k == 0 ? " N is the number of an element, from 0; NAME is a name of yours;\n"
                       "PAIR is default, or two materials a-b. clod explain KEY tells more.\n\n"
                     : "\n\n",
              out);
        clod_walk(schemas[k]->table, list_row, out);
    }
    char *all = out != NULL ? clod_text_close(&text) : NULL;
    if (all == NULL) {
        clod_status_fail(status, CLOD_FAILED, "out of memory");
    }
    return all;
}

/** Where no key is called so: the topmost keys of the kind of file that a verb reads. */
static void list_top(search *self, const clod_schema *const *schemas)
{
    char text[512];
    for (size_t k = 0; schemas[k] != NULL; k++) {
        const clod_table *table = schemas[k]->table;
        if (strcmp(schemas[k]->verb, self->key) != 0) {
            continue;
        }
        fprintf(self->out, "%s, read by clod %s: the topmost. clod explain KEY tells more.\n\n",
                schemas[k]->keys, schemas[k]->verb);
        for (size_t i = 0; i < table->count; i++) {
            fprintf(self->out, "  %-18s  %s\n", table->params[i].key,
                    clod_param_help(&table->params[i], text, sizeof text));
        }
        self->found += table->count;
    }
}

/** Look in all kinds of file: in each for the whole path, and without one for keys that end so. */
static void look_everywhere(search *self, const clod_schema *const *schemas)
{
    for (size_t k = 0; schemas[k] != NULL; k++) {
        const size_t before = self->found;
        self->schema = schemas[k];
        self->whole_paths = true;
        clod_walk(schemas[k]->table, look, self);
        if (self->found == before) {
            self->whole_paths = false;
            clod_walk(schemas[k]->table, look, self);
        }
    }
}

/** Where no key is called so: "hopper.wall_friction" is the key wall_friction of what clod hopper reads. */
static void look_behind_verb(search *self, const clod_schema *const *schemas)
{
    const char *key = self->key;
    for (size_t k = 0; schemas[k] != NULL; k++) {
        const size_t length = strlen(schemas[k]->verb);
        const clod_schema *const one[] = {schemas[k], NULL};
        if (strncmp(key, schemas[k]->verb, length) == 0 && key[length] == '.') {
            self->key = key + length + 1;
            self->near = clod_suggest_start(self->key);
            look_everywhere(self, one);
        }
    }
    self->key = key;
}

char *clod_schema_explain(const clod_schema *const *schemas, const char *key,
                          clod_status *status)
{
    CLOD_NEED(status);
    const clod_schema *const cases[] = {clod_schema_case(), NULL};
    schemas = schemas != NULL ? schemas : cases;
    if (key == NULL) {
        return explain_all(schemas, status);
    }
    clod_text text;
    search self = {.out = clod_text_open(&text), .key = key};
    if (self.out == NULL) {
        clod_status_fail(status, CLOD_FAILED, "out of memory");
        return NULL;
    }
    self.near = clod_suggest_start(key);
    look_everywhere(&self, schemas);
    if (self.found == 0) {
        list_top(&self, schemas);
        look_behind_verb(&self, schemas);
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

void clod_schema_free(char *text)
{
    clod_memory_free(text);
}
