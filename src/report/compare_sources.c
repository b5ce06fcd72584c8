#include "report/compare_head.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "clod/version.h"
#include "report/head.h"
#include "report/html.h"
#include "report/rounded.h"
#include "report/run_kinds.h"

#define BEGIN "<li>"
#define END "</li>"

/** A warning of a run, as HTML. */
typedef struct item {
    size_t run;
    const char *text; ///< in the run's list, borrowed
    size_t length;
    bool done; ///< it stands on the page
} item;

typedef struct items {
    item *item;   ///< [count] owned
    char **lists; ///< [runs] owned: list items of each run
    size_t count;
} items;

static bool add(items *self, size_t run, const char *text, size_t length)
{
    item *grown = clod_memory_grow(self->item, self->count, self->count + 1, sizeof *grown);
    if (grown != NULL) {
        self->item = grown;
        self->item[self->count++] = (item){.run = run, .text = text, .length = length};
    }
    return grown != NULL;
}

static bool collect(items *self, const clod_run_files *runs, size_t count, const json_t *lab)
{
    self->lists = clod_memory_alloc(count, sizeof *self->lists);
    bool good = self->lists != NULL;
    for (size_t k = 0; good && k < count; k++) {
        clod_text text;
        FILE *out = clod_text_open(&text);
        if (out != NULL) {
            clod_head_items(out, &runs[k], lab);
            self->lists[k] = clod_text_close(&text);
        }
        good = self->lists[k] != NULL;
        const char *at = good ? strstr(self->lists[k], BEGIN) : NULL;
        while (good && at != NULL) {
            const char *from = at + strlen(BEGIN);
            const char *end = strstr(from, END);
            good = add(self, k, from, (size_t)(end - from));
            at = strstr(end, BEGIN);
        }
    }
    return good;
}

/** Whether two warnings say the same of other numbers. */
static bool is_alike(const item *a, const item *b)
{
    return clod_text_alike(a->text, a->length, b->text, b->length);
}

static bool is_same(const item *a, const item *b)
{
    return a->length == b->length && memcmp(a->text, b->text, a->length) == 0;
}

static void put_text(FILE *out, const item *one)
{
    fprintf(out, "%.*s", (int)one->length, one->text);
}

/** Names of the runs with a warning like this; "all n runs". */
static void put_names(FILE *out, const items *self, size_t first, const clod_run_files *runs,
                      size_t count, size_t like)
{
    fputs("<strong>", out);
    if (like == count && count > 1) {
        fprintf(out, "All %zu runs", count);
    } else {
        const char *between = "";
        size_t last = count;
        for (size_t k = first; k < self->count; k++) {
            if (is_alike(&self->item[first], &self->item[k]) && self->item[k].run != last) {
                last = self->item[k].run;
                fputs(between, out);
                clod_html_text(out, runs[last].name);
                between = ", ";
            }
        }
    }
    fputs("</strong>: ", out);
}

/** The texts of all that are like the first, folded. */
static void put_each(FILE *out, items *self, size_t first, const clod_run_files *runs)
{
    fputs("<details><summary>the numbers of each</summary><ul>", out);
    for (size_t k = first; k < self->count; k++) {
        if (is_alike(&self->item[first], &self->item[k])) {
            fputs(BEGIN, out);
            clod_html_text(out, runs[self->item[k].run].name);
            fputs(": ", out);
            put_text(out, &self->item[k]);
            fputs(END, out);
        }
    }
    fputs("</ul></details>", out);
}

static void put_item(FILE *out, items *self, size_t first, const clod_run_files *runs,
                     size_t count)
{
    size_t like = 0, last = count;
    bool same = true;
    for (size_t k = first; k < self->count; k++) {
        if (is_alike(&self->item[first], &self->item[k])) {
            self->item[k].done = true;
            same = same && is_same(&self->item[first], &self->item[k]);
            like += self->item[k].run != last;
            last = self->item[k].run;
        }
    }
    fputs(BEGIN, out);
    put_names(out, self, first, runs, count, like);
    put_text(out, &self->item[first]);
    if (!same) {
        fputs(" <small>(as ", out);
        clod_html_text(out, runs[self->item[first].run].name);
        fputs(" has it)</small>", out);
        put_each(out, self, first, runs);
    }
    fputs(END "\n", out);
}

bool clod_compare_head_warnings(FILE *out, const clod_run_files *runs, size_t count,
                                const json_t *lab, clod_status *status)
{
    items all = {.count = 0};
    const bool good = collect(&all, runs, count, lab);
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
    } else if (all.count + clod_head_lab_count(lab) > 0) {
        fputs("<section class=\"warnings\" id=\"warnings\"><h2>Warnings</h2><ul>", out);
        for (size_t k = 0; k < all.count; k++) {
            if (!all.item[k].done) {
                put_item(out, &all, k, runs, count);
            }
        }
        fputs("</ul>", out);
        clod_head_lab_put(out, lab);
        fputs("</section>\n", out);
    } else if (runs[0].kind->checked) {
        fputs("<p class=\"good\">No warnings.</p>\n", out);
    }
    for (size_t k = 0; all.lists != NULL && k < count; k++) {
        clod_memory_free(all.lists[k]);
    }
    clod_memory_free(all.lists);
    clod_memory_free(all.item);
    return good;
}

// ---- provenance

static void put_number(FILE *out, const json_t *summary, const char *key)
{
    double ends[2];
    if (!clod_head_number(summary, key, ends)) {
        clod_html_cell(out, "td", "");
        return;
    }
    const double none = (double)NAN;
    const bool whole = ends[0] == floor(ends[0]) && ends[1] == floor(ends[1]); // seeds, grains
    const int digits = whole ? 0 : CLOD_ROUNDED_SHORT;
    clod_rounded_begin(out, "td", ends[0], none, "");
    clod_rounded_put(out, ends[0], none, none, digits, "");
    if (ends[0] != ends[1]) {
        fputs(" to ", out);
        clod_rounded_put(out, ends[1], none, none, digits, "");
    }
    fputs("</td>", out);
}

void clod_compare_head_sources(FILE *out, const clod_run_files *runs, size_t count)
{
    static const char *const NUMBERS[] = {"seed", "grains", "dt_s", "wall_clock_s"};
    clod_html_section(out, "provenance", "Where this comes from");
    fputs(
        "<div class=\"scroll\"><table class=\"sources\" id=\"sources-table\"><thead><tr><th>results "
        "folder</th><th>computed by</th><th>until</th><th>seed</th>"
        "<th>grains</th><th>time step [s]</th><th>computing time [s]</th></tr></thead>\n<tbody>",
        out);
    for (size_t k = 0; k < count; k++) {
        const char *version = clod_run_files_version(&runs[k]);
        char until[40] = "not known";
        if (runs[k].ended != NULL) {
            snprintf(until, sizeof until, "%.10s %.5s UTC", runs[k].ended, runs[k].ended + 11);
        }
        fputs("<tr>", out);
        clod_html_cell(out, "th", runs[k].folder);
        clod_html_cell(out, "td", version != NULL ? version : "not known");
        clod_html_cell(out, "td", until);
        for (size_t n = 0; n < sizeof NUMBERS / sizeof *NUMBERS; n++) {
            put_number(out, runs[k].summary, NUMBERS[n]);
        }
        fputs("</tr>\n", out);
    }
    fputs("</tbody></table></div>\n<p class=\"note\">This page was written by ", out);
    clod_html_text(out, clod_version_text());
    fputs(".</p>\n", out);
}
