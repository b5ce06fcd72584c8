#include "report/compare_free.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/compare_tables.h"
#include "report/field_axes.h"
#include "report/free_tables.h"
#include "report/rounded.h"
#include "report/summary_tables.h"

#define MOST 1000 ///< rows

static const clod_result_row ROWS[] = {
    {"time_s", "time", "", "s", 1.0, CLOD_ROUNDED_SHORT, NULL, "-", false},
    {"grains", "grains", "", "", 1.0, 0, NULL, "-", false},
    {"contacts", "contacts", "", "", 1.0, 0, NULL, "-", false},
    {"coordination", "coordination", "", "", 1.0, 3, NULL, "-", false},
    {"max_overlap", "largest overlap", "", "%", 100.0, CLOD_ROUNDED_SHORT, NULL, "-", false},
    {"kinetic_energy_J", "kinetic energy", "", "J", 1.0, CLOD_ROUNDED_SHORT, NULL, "-", false},
    {"wall_clock_s", "computing time", "", "s", 1.0, CLOD_ROUNDED_SHORT, NULL, "-", false}};

#define OWN (sizeof ROWS / sizeof *ROWS)

/** A number that runs tell of an object: a row of the comparison. */
typedef struct number {
    char *key, *text, *unit; ///< owned: of the flat summaries; the row's
    size_t table;            ///< of CLOD_FREE_TABLES
    bool whole;              ///< in all runs
    bool words;              ///< a text
    bool said;               ///< some run has one that is not zero, or not "no"
    bool spread;             ///< some run has an error
} number;

/** The numbers of all runs, in the order of the first run that tells them. */
typedef struct numbers {
    number *number; ///< [count] owned
    size_t count;
    json_t *at; ///< owned: place of each key
    bool more;  ///< there are numbers without a place
    bool lost;  ///< there was no memory for something
} numbers;

/** What is being made flat. */
typedef struct flattening {
    numbers *all;
    json_t *flat; ///< of this run
    size_t table;
} flattening;

static const json_t *summary_of(const json_t *summary, size_t g)
{
    return g == 0 ? summary : NULL;
}

/** Owned text "a b c". */
static char *join(const char *a, const char *b, const char *c)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fprintf(out, "%s %s %s", a, b, c);
    return clod_text_close(&text);
}

/** Owned name of a row, "lip: velocity x". */
static char *name_row(const clod_summary_cell *cell, const char *name)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fprintf(out, cell->axes[0] != '\0' ? "%s: %s %s" : "%s: %s%s", cell->of, name, cell->axes);
    return clod_text_close(&text);
}

/** Number of the row of a key, a new one if need be; takes the key. `MOST`: there is none. */
static size_t place_of(numbers *self, char *key, const clod_summary_cell *cell, size_t table)
{
    const json_t *known = json_object_get(self->at, key);
    if (known != NULL || self->count == MOST) {
        self->more = self->more || known == NULL;
        clod_memory_free(key);
        return known != NULL ? (size_t)json_integer_value(known) : MOST;
    }
    number *grown =
        clod_memory_grow(self->number, self->count, self->count + 1, sizeof *self->number);
    if (grown == NULL) {
        self->lost = true;
        clod_memory_free(key);
        return MOST;
    }
    char name[CLOD_FIGURE_NAME], unit[16];
    clod_summary_tables_name(cell->key, name, unit);
    self->number = grown;
    self->number[self->count] = (number){.key = key,
                                         .text = name_row(cell, name),
                                         .unit = clod_memory_text(unit),
                                         .table = table,
                                         .whole = true,
                                         .words = cell->words != NULL};
    const number *one = &self->number[self->count];
    if (one->text == NULL || one->unit == NULL ||
        json_object_set_new(self->at, key, json_integer((json_int_t)self->count)) != 0) {
        self->lost = true;
    }
    return self->count++;
}

/** Put a cell of a run's tables into its flat summary. */
static void take(void *context, const clod_summary_cell *cell)
{
    flattening *self = context;
    const clod_free_table *table = &CLOD_FREE_TABLES[self->table];
    char *whose = join(table->title, cell->of, cell->axes);
    char *key = whose != NULL ? join(whose, cell->key, "") : NULL;
    clod_memory_free(whose);
    if (key == NULL) {
        self->all->lost = true;
        return;
    }
    key[strlen(key) - 1] = '\0'; // the blank: a key ends with its unit
    const size_t k = place_of(self->all, key, cell, self->table);
    if (k == MOST) {
        return;
    }
    number *one = &self->all->number[k];
    json_t *value = cell->words != NULL ? json_string(cell->words)
                    : cell->error > 0.0
                        ? json_pack("{s:f, s:f}", "value", cell->value, "error", cell->error)
                        : json_pack("{s:f}", "value", cell->value);
    one->whole = one->whole && cell->value == round(cell->value) && fabs(cell->value) < 1e15;
    const bool nothing =
        cell->words != NULL ? strcmp(cell->words, "no") == 0 : cell->value == 0.0;
    one->said = one->said || !nothing;
    one->spread = one->spread || cell->error > 0.0;
    if (json_object_set_new(self->flat, one->key, value) != 0) {
        self->all->lost = true;
    }
}

/** A summary with the numbers of its objects beside its own; owned. */
static json_t *flatten(numbers *all, const clod_run_files *run)
{
    flattening self = {.all = all, .flat = json_copy((json_t *)run->summary)};
    // json_copy leaves out what it has no memory for
    all->lost = all->lost || json_object_size(self.flat) < json_object_size(run->summary);
    clod_field_axes_set(run);
    for (; self.flat != NULL && self.table < CLOD_FREE_TABLE_COUNT; self.table++) {
        json_t *objects = clod_free_tables_of(&CLOD_FREE_TABLES[self.table], run->summary);
        all->more = !clod_summary_tables_each(objects, &self, take) || all->more;
        json_decref(objects);
    }
    return self.flat;
}

/** The tables: that of every run, and those of objects of which a run tells something. */
static void lay_out(const numbers *self, clod_compare_table *table, clod_result_row *rows,
                    clod_compare_tables *all)
{
    memcpy(rows, ROWS, sizeof ROWS);
    table[0] = (clod_compare_table){.rows = OWN};
    *all = (clod_compare_tables){table, 1, rows, OWN, summary_of};
    for (size_t t = 0; t < CLOD_FREE_TABLE_COUNT; t++) {
        const clod_free_table *from = &CLOD_FREE_TABLES[t];
        clod_compare_table *to = &table[all->count];
        *to = (clod_compare_table){.title = from->title};
        for (size_t k = 0; k < self->count; k++) {
            const number *one = &self->number[k];
            if (one->table == t && (one->said || from->nothing)) {
                rows[all->row_count++] =
                    (clod_result_row){one->key,  one->text, "",
                                      one->unit, 1.0,       one->whole ? 0 : CLOD_ROUNDED_SHORT,
                                      NULL,      "-",       one->words};
                to->rows++;
                to->note = one->spread ? from->spread : to->note;
            }
        }
        all->count += to->rows > 0;
    }
}

static void free_numbers(numbers *self)
{
    for (size_t k = 0; k < self->count; k++) {
        clod_memory_free(self->number[k].key);
        clod_memory_free(self->number[k].text);
        clod_memory_free(self->number[k].unit);
    }
    clod_memory_free(self->number);
    json_decref(self->at);
}

bool clod_compare_free_results(clod_writer out, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status)
{
    (void)lab;
    numbers all = {.at = json_object()};
    clod_run_files *flat = clod_memory_alloc(count, sizeof *flat);
    for (size_t k = 0; flat != NULL && k < count; k++) {
        flat[k] = runs[k];
        flat[k].summary = flatten(&all, &runs[k]);
    }
    clod_result_row *rows = clod_memory_alloc(OWN + all.count, sizeof *rows);
    clod_compare_table table[1 + CLOD_FREE_TABLE_COUNT];
    clod_compare_tables tables;
    bool good = flat != NULL && rows != NULL && all.at != NULL && !all.lost;
    if (good) {
        lay_out(&all, table, rows, &tables);
        good = clod_compare_tables_put(out, &tables, flat, count, NULL, status);
        if (all.more) {
            clod_writer_mark(out, "<p class=\"note\">", "");
            clod_writer_text(out, "Not all that the runs measured has a place in these tables: "
                                  "the rest is in their summary.json.");
            clod_writer_mark(out, "</p>\n", "\n");
        }
    } else {
        clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
    }
    for (size_t k = 0; flat != NULL && k < count; k++) {
        json_decref(flat[k].summary);
    }
    clod_memory_free(rows);
    clod_memory_free(flat);
    free_numbers(&all);
    return good;
}
