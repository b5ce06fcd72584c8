#include "report/warnings_section.h"

#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/head.h"
#include "report/run_kinds.h"

/** A warning of a run. */
typedef struct item {
    size_t run;
    const char *part; ///< of the run that it is about, borrowed; NULL: none
    const char *text; ///< in the run's list, borrowed; begins with the part
    size_t behind;    ///< bytes of the part at its beginning
    bool done;        ///< it is written
} item;

typedef struct items {
    item *item;   ///< [count] owned
    char **lists; ///< [runs] owned: texts of each run, one behind the other
    size_t count;
    bool compared; ///< several runs stand side by side
} items;

/** The part of a run that a warning begins with, "point-1: ..."; NULL: none. */
static const char *part_of(const clod_run_files *run, const char *text)
{
    const char *part;
    for (size_t p = 0; (part = clod_run_files_part(run, p)) != NULL; p++) {
        const size_t own = strlen(part);
        if (strncmp(text, part, own) == 0 && strncmp(text + own, ": ", 2) == 0) {
            return part;
        }
    }
    return NULL;
}

static bool add(items *self, const clod_run_files *runs, size_t run, const char *text)
{
    item *grown = clod_memory_grow(self->item, self->count, self->count + 1, sizeof *grown);
    if (grown != NULL) {
        const char *part = part_of(&runs[run], text);
        self->item = grown;
        self->item[self->count++] = (item){.run = run,
                                           .part = part,
                                           .text = text,
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
        const size_t found = out != NULL ? clod_head_warnings(out, &runs[k], lab) : 0;
        self->lists[k] = out != NULL ? clod_text_close(&text) : NULL;
        good = self->lists[k] != NULL;
        const char *at = self->lists[k];
        for (size_t i = 0; good && i < found; i++) {
            good = add(self, runs, k, at);
            at += strlen(at) + 1;
        }
    }
    return good;
}

/** A warning without the part that it begins with. */
static const char *behind_part(const item *one)
{
    return one->text + one->behind;
}

/** Whether two warnings say the same of other numbers, and in one run of other parts: names of inlets and gauges may be
 *  numbers, too. */
static bool is_alike(const items *self, const item *a, const item *b)
{
    const char *const mine = behind_part(a), *const other = behind_part(b);
    const bool both = a->part != NULL && b->part != NULL;
    return a == b || ((both || (self->compared && a->part == b->part)) &&
                      clod_text_alike(mine, strlen(mine), other, strlen(other)));
}

/** Whose a warning is: of a run, of a part of it. */
static void put_owner(clod_writer out, const items *self, const item *one,
                      const clod_run_files *runs)
{
    clod_writer_text(out, self->compared ? runs[one->run].name : one->part);
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
static void put_names(clod_writer out, const items *self, size_t first,
                      const clod_run_files *runs, bool all, size_t count)
{
    char text[40];
    const char *between = "";
    clod_writer_mark(out, "<strong>", "");
    if (all) {
        snprintf(text, sizeof text, "All %zu runs", count);
        clod_writer_text(out, text);
    }
    for (size_t k = first; k < self->count && !all; k++) {
        if (is_alike(self, &self->item[first], &self->item[k]) && !is_named(self, first, k)) {
            clod_writer_text(out, between);
            put_owner(out, self, &self->item[k], runs);
            between = ", ";
        }
    }
    clod_writer_mark(out, "</strong>: ", ": ");
}

/** The texts of all that are like the first, folded on the page. */
static void put_each(clod_writer out, const items *self, size_t first,
                     const clod_run_files *runs)
{
    clod_writer_mark(out, "<details><summary>the numbers of each</summary><ul>", "");
    for (size_t k = first; k < self->count; k++) {
        if (is_alike(self, &self->item[first], &self->item[k])) {
            clod_writer_mark(out, "<li>", "\n    ");
            if (self->compared) {
                put_owner(out, self, &self->item[k], runs);
                clod_writer_text(out, ": ");
            }
            clod_writer_text(out, self->item[k].text);
            clod_writer_mark(out, "</li>", "");
        }
    }
    clod_writer_mark(out, "</ul></details>", "");
}

/** Say whose numbers the one that is written has. @param like  how many there are, of so many owners */
static void put_which(clod_writer out, const items *self, const item *one,
                      const clod_run_files *runs, size_t like, size_t owners)
{
    char text[60];
    clod_writer_mark(out, " <small>(", " (");
    if (owners > 1) {
        clod_writer_text(out, "as ");
        put_owner(out, self, one, runs);
        clod_writer_text(out, " has it");
    } else {
        snprintf(text, sizeof text, "the first of %zu", like);
        clod_writer_text(out, text);
    }
    clod_writer_mark(out, ")</small>", ")");
}

static void put_item(clod_writer out, items *self, size_t first, const clod_run_files *runs,
                     size_t count)
{
    const item *one = &self->item[first];
    size_t like = 0, owners = 0;
    bool same = true, parts = false;
    for (size_t k = first; k < self->count; k++) {
        if (is_alike(self, one, &self->item[k])) {
            owners += !is_named(self, first, k);
            self->item[k].done = true;
            same = same && strcmp(behind_part(one), behind_part(&self->item[k])) == 0;
            parts = parts || (one->part != NULL && strcmp(one->part, self->item[k].part) != 0);
            like++;
        }
    }
    clod_writer_mark(out, "<li>", "- ");
    if (self->compared || like > 1) {
        put_names(out, self, first, runs, self->compared && owners == count && count > 1,
                  count);
    }
    clod_writer_text(out, self->compared || like == 1 ? one->text : behind_part(one));
    if (!same || (self->compared && parts)) {
        put_which(out, self, one, runs, like, owners);
        put_each(out, self, first, runs);
    }
    clod_writer_mark(out, "</li>\n", "\n");
}

/** The warnings of the laboratory's points under a heading of their own; without any, nothing. */
static void put_lab(clod_writer out, const char *texts, size_t count)
{
    if (count > 0) {
        clod_writer_mark(out, "<h3>Laboratory points</h3><ul>", "\nLaboratory points\n");
        for (size_t k = 0; k < count; k++) {
            clod_writer_mark(out, "<li>", "- ");
            clod_writer_text(out, texts);
            clod_writer_mark(out, "</li>", "\n");
            texts += strlen(texts) + 1;
        }
        clod_writer_mark(out, "</ul>", "");
    }
}

bool clod_warnings_section_put(clod_writer out, const clod_run_files *runs, size_t count,
                               bool compared, const json_t *lab, clod_status *status)
{
    items all = {.compared = compared};
    clod_text text;
    FILE *stream = clod_text_open(&text);
    const size_t of_lab = stream != NULL ? clod_head_lab_warnings(stream, lab) : 0;
    char *lab_texts = stream != NULL ? clod_text_close(&text) : NULL;
    const bool good = lab_texts != NULL && collect(&all, runs, count, lab);
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the warnings of the page.");
    } else if (all.count + of_lab > 0) {
        clod_writer_mark(out,
                         "<section class=\"warnings\" id=\"warnings\"><h2>Warnings</h2><ul>",
                         "Warnings\n");
        for (size_t k = 0; k < all.count; k++) {
            if (!all.item[k].done) {
                put_item(out, &all, k, runs, count);
            }
        }
        clod_writer_mark(out, "</ul>", "");
        put_lab(out, lab_texts, of_lab);
        clod_writer_mark(out, "</section>\n", "\n");
    } else if (runs[0].kind->checked) { // free runs have no checks, but for their streams
        clod_writer_mark(out, "<p class=\"good\">No warnings.</p>\n", "No warnings.\n\n");
    }
    for (size_t k = 0; all.lists != NULL && k < count; k++) {
        clod_memory_free(all.lists[k]);
    }
    clod_memory_free(all.lists);
    clod_memory_free(all.item);
    clod_memory_free(lab_texts);
    return good;
}
