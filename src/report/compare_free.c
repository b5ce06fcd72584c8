#include "report/compare_free.h"

#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/compare_tables.h"
#include "report/html.h"
#include "report/rounded.h"

#define MOST 200 ///< numbers that runs measured; of more the page says how many

static const clod_result_row ROWS[] = {
    {"time_s", "time", "", "s", 1.0, CLOD_ROUNDED_SHORT, NULL, "-", false},
    {"grains", "grains", "", "", 1.0, 0, NULL, "-", false},
    {"contacts", "contacts", "", "", 1.0, 0, NULL, "-", false},
    {"coordination", "coordination", "", "", 1.0, 3, NULL, "-", false},
    {"max_overlap", "largest overlap", "", "%", 100.0, CLOD_ROUNDED_SHORT, NULL, "-", false},
    {"kinetic_energy_J", "kinetic energy", "", "J", 1.0, CLOD_ROUNDED_SHORT, NULL, "-", false},
    {"wall_clock_s", "computing time", "", "s", 1.0, CLOD_ROUNDED_SHORT, NULL, "-", false}};

#define OWN (sizeof ROWS / sizeof *ROWS)

/** What a measure tells of each of its objects. */
static const struct {
    const char *of, *key,
        *error; ///< in the summary; where the error is: NULL: in the number's object
    const char *text, *unit, *ending; ///< of the row, and of the key that the number has here
} MEASURES[] = {
    {"repose", "angle_deg", "error_deg", "angle of repose", "deg", "_deg"},
    {"mixing", "lacey", NULL, "mixing index (Lacey)", "", ""},
    {"gauges", "mass_flow_kg_per_s", NULL, "mass flow", "kg/s", "_kg_per_s"},
    {"gauges", "flow_through_kg_per_s", NULL, "flow through the plane", "kg/s",
     "_through_kg_per_s"},
};
#define MEASURE_COUNT (sizeof MEASURES / sizeof *MEASURES)

/** Rows, and the texts that those of measures have. */
typedef struct table {
    clod_result_row row[OWN + MOST];
    char *key[MOST], *text[MOST]; ///< owned
    size_t measured;
    json_t *left_out; ///< keys of the numbers beyond MOST, each once
    bool lost;        ///< there was no memory for something
} table;

static const json_t *summary_of(const json_t *summary, size_t g)
{
    return g == 0 ? summary : NULL;
}

/** Owned "repose heap_deg", under which a number stands beside others. */
static char *key_of(size_t m, const char *name)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fprintf(out, "%s %s%s", MEASURES[m].of, name, MEASURES[m].ending);
    return clod_text_close(&text);
}

/** Owned "angle of repose: heap" as HTML. */
static char *text_of(size_t m, const char *name)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fprintf(out, "%s: ", MEASURES[m].text);
    clod_html_text(out, name);
    return clod_text_close(&text);
}

/** Add the row of a number if it is new and there is room; takes the key. */
static void add_row(table *self, size_t m, const char *name, char *key)
{
    bool known = false;
    for (size_t k = 0; k < self->measured && !known; k++) {
        known = strcmp(self->key[k], key) == 0;
    }
    if (known || self->measured == MOST) {
        if (!known && json_object_set_new(self->left_out, key, json_true()) != 0) {
            self->lost = true;
        }
        clod_memory_free(key);
        return;
    }
    const size_t k = self->measured++;
    self->key[k] = key;
    self->text[k] = text_of(m, name);
    self->lost = self->lost || self->text[k] == NULL;
    self->row[OWN + k] = (clod_result_row){
        key, self->text[k], "", MEASURES[m].unit, 1.0, CLOD_ROUNDED_SHORT, NULL, "-", false};
}

/** A number with its error, where it has one (of a gauge blocks differ, which is none); NULL without a number. */
static json_t *number_of(const json_t *object, size_t m)
{
    const json_t *value = json_object_get(object, MEASURES[m].key);
    const json_t *mean = json_is_object(value) ? json_object_get(value, "mean") : value;
    const json_t *error =
        MEASURES[m].error != NULL ? json_object_get(object, MEASURES[m].error) : NULL;
    if (!json_is_number(mean)) {
        return NULL;
    }
    return json_is_number(error) ? json_pack("{s:f, s:f}", "value", json_number_value(mean),
                                             "error", json_number_value(error))
                                 : json_pack("{s:f}", "value", json_number_value(mean));
}

/** A summary with the numbers of its measures beside its own; owned. */
static json_t *flatten(table *self, const json_t *summary)
{
    json_t *flat = json_copy((json_t *)summary);
    for (size_t m = 0; flat != NULL && m < MEASURE_COUNT; m++) {
        const char *name;
        json_t *object;
        json_object_foreach(json_object_get(summary, MEASURES[m].of), name, object)
        {
            json_t *number = number_of(object, m);
            char *key = number != NULL ? key_of(m, name) : NULL;
            if (key != NULL && json_object_set(flat, key, number) == 0) {
                add_row(self, m, name, key);
            } else if (number != NULL) {
                self->lost = true;
                clod_memory_free(key);
            }
            json_decref(number);
        }
    }
    self->lost = self->lost || (summary != NULL && flat == NULL);
    return flat;
}

bool clod_compare_free_results(FILE *out, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status)
{
    (void)lab;
    table all = {.left_out = json_object()};
    clod_run_files *flat = clod_memory_alloc(count, sizeof *flat);
    memcpy(all.row, ROWS, sizeof ROWS);
    for (size_t k = 0; flat != NULL && k < count; k++) {
        flat[k] = runs[k];
        flat[k].summary = flatten(&all, runs[k].summary);
    }
    const bool good =
        flat != NULL && all.left_out != NULL && !all.lost
            ? clod_compare_tables_put(out, all.row, OWN + all.measured, flat, count, NULL,
                                      summary_of, status)
            : clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
    if (good && json_object_size(all.left_out) > 0) {
        fprintf(
            out,
            "<p class=\"note\">%zu more angles of repose, mixing indices and mass flows are in "
            "the runs' summary.json.</p>\n",
            json_object_size(all.left_out));
    }
    json_decref(all.left_out);
    for (size_t k = 0; flat != NULL && k < count; k++) {
        json_decref(flat[k].summary);
    }
    for (size_t k = 0; k < all.measured; k++) {
        clod_memory_free(all.key[k]);
        clod_memory_free(all.text[k]);
    }
    clod_memory_free(flat);
    return good;
}
