#include "report/warnings_section.h"

#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/head.h"
#include "report/html.h"
#include "report/run_kinds.h"

#define BEGIN "<li>"
#define END "</li>"

/** A warning of a run, as HTML. */
typedef struct item {
    size_t run;
    const char *part;      ///< of the run that it is about, borrowed; NULL: none
    const char *text;      ///< in the run's list, borrowed; begins with the part
    size_t length, behind; ///< bytes of it, and of the part at its beginning
    bool done;             ///< it stands on the page
} item;

typedef struct items {
    item *item;   ///< [count] owned
    char **lists; ///< [runs] owned: list items of each run
    size_t count;
    bool compared; ///< several runs stand side by side
} items;

/** The part of a run that a warning begins with, "point-1: ..."; NULL: none. */
static const char *part_of(const clod_run_files *run, const char *text, size_t length)
{
    const char *part;
    for (size_t p = 0; (part = clod_run_files_part(run, p)) != NULL; p++) {
        const size_t own = strlen(part);
        if (own + 2 <= length && strncmp(text, part, own) == 0 &&
            strncmp(text + own, ": ", 2) == 0) {
            return part;
        }
    }
    return NULL;
}

static bool add(items *self, const clod_run_files *runs, size_t run, const char *text,
                size_t length)
{
    item *grown = clod_memory_grow(self->item, self->count, self->count + 1, sizeof *grown);
    if (grown != NULL) {
        const char *part = part_of(&runs[run], text, length);
        self->item = grown;
        self->item[self->count++] = (item){.run = run,
                                           .part = part,
                                           .text = text,
                                           .length = length,
                                           .behind = part != NULL ? strlen(part) + 2 : 0};
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
            good = add(self, runs, k, from, (size_t)(end - from));
            at = strstr(end, BEGIN);
        }
    }
    return good;
}

/** Whether two warnings say the same of other numbers, and in one run of other parts: names of inlets and gauges may be
 *  numbers, too. */
static bool is_alike(const items *self, const item *a, const item *b)
{
    const bool both = a->part != NULL && b->part != NULL;
    return a == b || ((both || (self->compared && a->part == b->part)) &&
                      clod_text_alike(a->text + a->behind, a->length - a->behind,
                                      b->text + b->behind, b->length - b->behind));
}

static bool is_same(const item *a, const item *b)
{
    const size_t length = a->length - a->behind;
    return b->length - b->behind == length &&
           memcmp(a->text + a->behind, b->text + b->behind, length) == 0;
}

static void put_text(FILE *out, const item *one, size_t from)
{
    fprintf(out, "%.*s", (int)(one->length - from), one->text + from);
}

/** Whose a warning is: of a run, of a part of it. */
static void put_owner(FILE *out, const items *self, const item *one, const clod_run_files *runs)
{
    clod_html_text(out, self->compared ? runs[one->run].name : one->part);
}

/** Whether a warning like this of the same owner stands before it. */
static bool is_named(const items *self, size_t first, size_t k)
{
    for (size_t j = first; j < k; j++) {
        if (is_alike(self, &self->item[first], &self->item[j]) &&
            (self->compared ? self->item[j].run == self->item[k].run
                            : strcmp(self->item[j].part, self->item[k].part) == 0)) {
            return true;
        }
    }
    return false;
}

/** Names of the runs, or parts, with a warning like this; "All n runs". */
static void put_names(FILE *out, const items *self, size_t first, const clod_run_files *runs,
                      bool all, size_t count)
{
    const char *between = "";
    fputs("<strong>", out);
    if (all) {
        fprintf(out, "All %zu runs", count);
    }
    for (size_t k = first; k < self->count && !all; k++) {
        if (is_alike(self, &self->item[first], &self->item[k]) && !is_named(self, first, k)) {
            fputs(between, out);
            put_owner(out, self, &self->item[k], runs);
            between = ", ";
        }
    }
    fputs("</strong>: ", out);
}

/** The texts of all that are like the first, folded. */
static void put_each(FILE *out, const items *self, size_t first, const clod_run_files *runs)
{
    fputs("<details><summary>the numbers of each</summary><ul>", out);
    for (size_t k = first; k < self->count; k++) {
        if (is_alike(self, &self->item[first], &self->item[k])) {
            fputs(BEGIN, out);
            if (self->compared) {
                put_owner(out, self, &self->item[k], runs);
                fputs(": ", out);
            }
            put_text(out, &self->item[k], 0);
            fputs(END, out);
        }
    }
    fputs("</ul></details>", out);
}

static void put_item(FILE *out, items *self, size_t first, const clod_run_files *runs,
                     size_t count)
{
    const item *one = &self->item[first];
    size_t like = 0, owners = 0;
    bool same = true, parts = false;
    for (size_t k = first; k < self->count; k++) {
        if (is_alike(self, one, &self->item[k])) {
            owners += !is_named(self, first, k);
            self->item[k].done = true;
            same = same && is_same(one, &self->item[k]);
            parts = parts || (one->part != NULL && strcmp(one->part, self->item[k].part) != 0);
            like++;
        }
    }
    fputs(BEGIN, out);
    if (self->compared || like > 1) {
        put_names(out, self, first, runs, self->compared && owners == count && count > 1,
                  count);
    }
    put_text(out, one, self->compared || like == 1 ? 0 : one->behind);
    if (!same || (self->compared && parts)) {
        if (owners > 1) {
            fputs(" <small>(as ", out);
            put_owner(out, self, one, runs);
            fputs(" has it)</small>", out);
        } else {
            fprintf(out, " <small>(the first of %zu)</small>", like);
        }
        put_each(out, self, first, runs);
    }
    fputs(END "\n", out);
}

bool clod_warnings_section_put(FILE *out, const clod_run_files *runs, size_t count,
                               bool compared, const json_t *lab, clod_status *status)
{
    items all = {.compared = compared};
    const bool good = collect(&all, runs, count, lab);
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the warnings of the page.");
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
    } else if (runs[0].kind->checked) { // free runs have no checks, but for their streams
        fputs("<p class=\"good\">No warnings.</p>\n", out);
    }
    for (size_t k = 0; all.lists != NULL && k < count; k++) {
        clod_memory_free(all.lists[k]);
    }
    clod_memory_free(all.lists);
    clod_memory_free(all.item);
    return good;
}
