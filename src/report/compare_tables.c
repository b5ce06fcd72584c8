#include "report/compare_tables.h"

#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/html.h"
#include "report/shear_rows.h"
#include "sim/case_diff.h"

#define VALUE 128 ///< bytes of one that are shown
#define MOST_KEYS 200

static void begin_table(FILE *out)
{
    fputs("<div class=\"scroll\"><table class=\"copied\" id=\"results-table\"><thead>", out);
}

static void end_table(FILE *out)
{
    fputs("</tbody></table></div>\n", out);
}

static void put_loci(FILE *out, const char *name, const json_t *study)
{
    const json_t *locus;
    for (size_t g = 0; (locus = clod_shear_locus(study, g)) != NULL; g++) {
        fputs("<tr>", out);
        clod_html_cell(out, "th", name);
        for (size_t k = 0; k < CLOD_SHEAR_ROW_COUNT; k++) {
            fputs("<td>", out);
            clod_shear_value(out, locus, &CLOD_SHEAR_ROWS[k]);
            fputs("</td>", out);
        }
        clod_html_cell(out, "td", json_string_value(json_object_get(locus, "flow")));
        fputs("</tr>\n", out);
    }
}

bool clod_compare_tables_shear(FILE *out, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status)
{
    (void)status;
    begin_table(out);
    fputs("<tr><th>run</th>", out);
    for (size_t k = 0; k < CLOD_SHEAR_ROW_COUNT; k++) {
        fprintf(out, "<th>%s<br><small>%s</small></th>", CLOD_SHEAR_ROWS[k].symbol,
                CLOD_SHEAR_ROWS[k].unit);
    }
    fputs("<th>flow (Jenike)</th></tr></thead>\n<tbody>", out);
    for (size_t k = 0; k < count; k++) {
        put_loci(out, runs[k].name, json_object_get(runs[k].summary, "locus"));
    }
    put_loci(out, "laboratory", lab);
    end_table(out);
    return true;
}

/** Columns of numbers that stand in the summary or in a list of it. */
typedef struct column {
    const char *key, *text, *format;
    double factor;
} column;

static void put_numbers(FILE *out, const char *name, const json_t *from, const column *columns,
                        size_t count)
{
    fputs("<tr>", out);
    clod_html_cell(out, "th", name);
    for (size_t k = 0; k < count; k++) {
        char text[64] = "";
        const json_t *value = json_object_get(from, columns[k].key);
        if (json_is_number(value)) {
            snprintf(text, sizeof text, columns[k].format,
                     columns[k].factor * json_number_value(value));
        }
        clod_html_cell(out, "td", text);
    }
    fputs("</tr>\n", out);
}

static void put_heads(FILE *out, const column *columns, size_t count)
{
    fputs("<tr><th>run</th>", out);
    for (size_t k = 0; k < count; k++) {
        clod_html_cell(out, "th", columns[k].text);
    }
    fputs("</tr></thead>\n<tbody>", out);
}

bool clod_compare_tables_uniaxial(FILE *out, const clod_run_files *runs, size_t count,
                                  const json_t *lab, clod_status *status)
{
    (void)lab;
    (void)status;
    static const column COLUMNS[] = {
        {"sigma_1_Pa", "sigma_1 [kPa]", "%.3f", 1e-3},
        {"bulk_density_kg_m3", "bulk density [kg/m3]", "%.0f", 1.0},
        {"sigma_c_Pa", "sigma_c [kPa]", "%.3f", 1e-3},
        {"sigma_c_error_Pa", "its error [kPa]", "%.3f", 1e-3},
        {"strain_at_peak", "strain at the peak [%]", "%.2f", 100.0},
        {"ffc", "ffc", "%.2f", 1.0}};
    const size_t columns = sizeof COLUMNS / sizeof *COLUMNS;
    begin_table(out);
    put_heads(out, COLUMNS, columns);
    for (size_t k = 0; k < count; k++) {
        size_t s;
        const json_t *one;
        json_array_foreach(json_object_get(runs[k].summary, "flow_function"), s, one)
        {
            put_numbers(out, runs[k].name, one, COLUMNS, columns);
        }
    }
    end_table(out);
    return true;
}

bool clod_compare_tables_free(FILE *out, const clod_run_files *runs, size_t count,
                              const json_t *lab, clod_status *status)
{
    (void)lab;
    (void)status;
    static const column COLUMNS[] = {{"time_s", "time [s]", "%.5g", 1.0},
                                     {"grains", "grains", "%.0f", 1.0},
                                     {"contacts", "contacts", "%.0f", 1.0},
                                     {"coordination", "coordination", "%.3f", 1.0},
                                     {"max_overlap", "largest overlap [%]", "%.3g", 100.0},
                                     {"kinetic_energy_J", "kinetic energy [J]", "%.4g", 1.0},
                                     {"wall_clock_s", "computing time [s]", "%.4g", 1.0}};
    const size_t columns = sizeof COLUMNS / sizeof *COLUMNS;
    begin_table(out);
    put_heads(out, COLUMNS, columns);
    for (size_t k = 0; k < count; k++) {
        put_numbers(out, runs[k].name, runs[k].summary, COLUMNS, columns);
    }
    end_table(out);
    return true;
}

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

/** A row: the value of a key in every run. */
static bool put_key(FILE *out, const char *key, const clod_run_files *runs, size_t count,
                    clod_status *status)
{
    char first[VALUE] = "";
    fputs("<tr>", out);
    clod_html_cell(out, "th", key);
    for (int pass = 0; pass < 2; pass++) { // the first run's value is told by those that differ
        for (size_t k = 1; k < count; k++) {
            lookup one = {.key = key};
            if (!clod_case_differences(runs[0].complete, runs[k].complete, look_up, &one,
                                       status)) {
                return false;
            }
            if (pass == 0 && one.differs) {
                snprintf(first, sizeof first, "%s", one.first);
            } else if (pass == 1) {
                clod_html_cell(out, "td", one.differs ? one.value : first);
            }
        }
        if (pass == 0) {
            clod_html_cell(out, "td", first);
        }
    }
    fputs("</tr>\n", out);
    return true;
}

/** A row for each key that differs. */
static bool put_keys(FILE *out, const key_list *keys, const clod_run_files *runs, size_t count,
                     clod_status *status)
{
    bool good = true;
    fputs(
        "<div class=\"scroll\"><table class=\"copied\" id=\"keys-table\"><thead><tr><th>key</th>",
        out);
    for (size_t k = 0; k < count; k++) {
        clod_html_cell(out, "th", runs[k].name);
    }
    fputs("</tr></thead>\n<tbody>", out);
    for (size_t k = 0; good && k < keys->count; k++) {
        good = put_key(out, keys->name[k], runs, count, status);
    }
    fputs("</tbody></table></div>\n", out);
    if (keys->count == MOST_KEYS) {
        fprintf(out, "<p class=\"note\">Only the first %d keys are listed.</p>\n", MOST_KEYS);
    }
    return good;
}

bool clod_compare_tables_keys(FILE *out, const clod_run_files *runs, size_t count,
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
        fputs("<p>Nothing: the cases are the same.</p>\n", out);
    } else if (good) {
        good = put_keys(out, &keys, runs, count, status);
    }
    for (size_t k = 0; k < keys.count; k++) {
        clod_memory_free(keys.name[k]);
    }
    return good;
}
