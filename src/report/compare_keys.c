#include "report/compare_keys.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/compare_seeds.h"
#include "report/html.h"
#include "report/result_table.h"
#include "sim/case_diff.h"

#define VALUE 128 ///< bytes of one that are shown
#define MOST_KEYS 200

/** Keys that differ from those of the first run, each once, in the order in which they come. */
typedef struct key_list {
    char *name[MOST_KEYS]; ///< owned
    size_t count;
    bool lost; ///< there was no memory for one
} key_list;

static void note_key(void *context, const char *key, const char *there, const char *here)
{
    key_list *self = context;
    (void)there;
    (void)here;
    for (size_t k = 0; k < self->count; k++) {
        if (strcmp(self->name[k], key) == 0) {
            return;
        }
    }
    if (self->count < MOST_KEYS) {
        char *name = clod_memory_text(key);
        self->lost = self->lost || name == NULL;
        self->name[self->count] = name;
        self->count += name != NULL ? 1 : 0;
    }
}

/** The value of a key in the case of a run. */
typedef struct lookup {
    const char *key;
    char first[VALUE], value[VALUE]; ///< in the first run and in this one
    bool differs;
} lookup;

/** A value, or a stroke for none. */
static void copy_value(char to[VALUE], const char *value)
{
    const char *from = value != NULL ? value : "-";
    clod_text_fit(to, VALUE, VALUE, from, strlen(from));
}

static void look_up(void *context, const char *key, const char *there, const char *here)
{
    lookup *self = context;
    if (strcmp(self->key, key) == 0) {
        self->differs = true;
        copy_value(self->first, there);
        copy_value(self->value, here);
    }
}

/** The value of a key in a run. */
static bool value_of(char value[VALUE], const char *key, const clod_run_files *runs,
                     size_t count, size_t k, clod_status *status)
{
    snprintf(value, VALUE, "-");
    for (size_t other = k > 0 ? 0 : 1; other < (k > 0 ? 1 : count); other++) {
        lookup one = {.key = key};
        if (!clod_case_differences(runs[0].complete, runs[k > 0 ? k : other].complete, look_up,
                                   &one, status)) {
            return false;
        }
        if (one.differs) { // the first run's value is told by any that differs
            snprintf(value, VALUE, "%s", k > 0 ? one.value : one.first);
            return true;
        }
    }
    return k == 0 || value_of(value, key, runs, count, 0, status);
}

static bool put_value(FILE *out, const char *key, const clod_run_files *runs, size_t count,
                      size_t k, clod_status *status)
{
    char value[VALUE];
    const bool good = value_of(value, key, runs, count, k, status);
    clod_html_cell(out, "td", value);
    return good;
}

static void put_heads(FILE *out, const char *first)
{
    fprintf(out,
            "<div class=\"scroll\"><table class=\"copied\" id=\"keys-table\"><thead><tr><th>"
            "%s</th>",
            first);
}

/** A row for each key that differs. */
static bool put_by_key(FILE *out, const key_list *keys, const clod_run_files *runs,
                       size_t count, clod_status *status)
{
    bool good = true;
    put_heads(out, "key");
    for (size_t k = 0; k < count; k++) {
        clod_html_cell(out, "th", runs[k].name);
    }
    fputs("</tr></thead>\n<tbody>", out);
    for (size_t q = 0; good && q < keys->count; q++) {
        fputs("<tr>", out);
        clod_html_cell(out, "th", keys->name[q]);
        for (size_t k = 0; good && k < count; k++) {
            good = put_value(out, keys->name[q], runs, count, k, status);
        }
        fputs("</tr>\n", out);
    }
    return good;
}

/** A row for each run: where they are more than a page is wide. */
static bool put_by_run(FILE *out, const key_list *keys, const clod_run_files *runs,
                       size_t count, clod_status *status)
{
    bool good = true;
    put_heads(out, "run");
    for (size_t q = 0; q < keys->count; q++) {
        clod_html_cell(out, "th", keys->name[q]);
    }
    fputs("</tr></thead>\n<tbody>", out);
    for (size_t k = 0; good && k < count; k++) {
        fputs("<tr>", out);
        clod_html_cell(out, "th", runs[k].name);
        for (size_t q = 0; good && q < keys->count; q++) {
            good = put_value(out, keys->name[q], runs, count, k, status);
        }
        fputs("</tr>\n", out);
    }
    return good;
}

static bool put_keys(FILE *out, const key_list *keys, const clod_run_files *runs, size_t count,
                     clod_status *status)
{
    const bool long_table = count > CLOD_RESULT_COLUMNS && keys->count <= CLOD_RESULT_COLUMNS;
    const bool good = (long_table ? put_by_run : put_by_key)(out, keys, runs, count, status);
    fputs("</tbody></table></div>\n", out);
    if (keys->count == MOST_KEYS) {
        fprintf(out, "<p class=\"note\">Only the first %d keys are listed.</p>\n", MOST_KEYS);
    }
    return good;
}

/** Say that nothing differs, and what follows from it. */
static void put_none(FILE *out, const clod_run_files *runs, size_t count)
{
    bool same = true;
    for (size_t k = 1; k < count; k++) {
        same = same && clod_compare_seeds_origin(&runs[0], &runs[k]);
    }
    if (count < 2 || !same) {
        fprintf(out, "<p>Nothing: the cases are the same%s.</p>\n",
                same ? "" : "; the runs began from other grains (clod run --from)");
        return;
    }
    fprintf(
        out,
        "<p>Nothing: the cases are the same, and so are their seeds. These are %zu runs of one "
        "packing: the same version of clod computes the same bits every time, so that they "
        "agree says nothing about scatter.</p>\n",
        count);
}

bool clod_compare_keys_put(FILE *out, const clod_run_files *runs, size_t count,
                           clod_status *status)
{
    key_list keys = {.count = 0};
    bool good = true;
    for (size_t k = 1; good && k < count; k++) {
        good =
            clod_case_differences(runs[0].complete, runs[k].complete, note_key, &keys, status);
    }
    if (good && keys.lost) {
        good = clod_status_fail(status, CLOD_FAILED, "no memory to compare cases");
    }
    if (good && keys.count == 0) {
        put_none(out, runs, count);
    } else if (good) {
        good = put_keys(out, &keys, runs, count, status);
    }
    for (size_t k = 0; k < keys.count; k++) {
        clod_memory_free(keys.name[k]);
    }
    return good;
}
