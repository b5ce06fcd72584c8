#include "report/series_compare.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "report/flow_figure.h"
#include "report/series_groups.h"
#include "report/shear_rows.h"
#include "report/table.h"

#define MOST_STRESSES 64
#define MOST_FIGURES 24

/** Endings of columns of free runs that are compared. */
static const char *const FREE[] = {"kinetic_energy", "max_speed",  "grains", "mass",
                                   "mass_flow",      "power",      "speed",  "force_z",
                                   "resting_mass",   "mass_share", "largest"};

/** How columns and units of the files are shown. */
static void set_axis(clod_figure_axis *axis, const char *name, const char *unit)
{
    char words[CLOD_FIGURE_NAME];
    clod_series_groups_words(clod_series_groups_quantity(name), words);
    if (strcmp(unit, "Pa") == 0) {
        clod_figure_axis_set(axis, words, "kPa", 1e-3);
    } else if (strcmp(name, "displacement") == 0 || strcmp(name, "height") == 0) {
        clod_figure_axis_set(axis, words, "mm", 1e3);
    } else {
        clod_figure_axis_set(axis, words, unit, 1.0);
    }
}

/** Add the column of a table; tables without it add nothing. */
static void add_table(clod_figure *figure, const clod_table *table, const char *over,
                      const char *column, const char *name, size_t number)
{
    const int at = clod_table_find(table, over);
    const int of = clod_table_find(table, column);
    const bool has = at >= 0 && of >= 0;
    double *x = has ? clod_table_numbers(table, at) : NULL;
    double *y = x != NULL ? clod_table_numbers(table, of) : NULL;
    figure->lost = figure->lost || (has && y == NULL);
    if (y != NULL) {
        const size_t first = strcmp(over, "time") == 0 ? 0 : clod_figure_begin(x, table->rows);
        set_axis(&figure->x, over, table->units[at]);
        set_axis(&figure->y, column, table->units[of]);
        clod_figure_add(figure, name, CLOD_FIGURE_LINE, (int)number, table->rows - first,
                        x + first, y + first, NULL);
    }
    clod_memory_free(x);
    clod_memory_free(y);
}

static bool is_shown(const clod_series_curves *curves, const char *part)
{
    const size_t length = strlen(part), wanted = strlen(curves->part);
    return curves->whole ? length >= wanted && strcmp(part + length - wanted, curves->part) == 0
                         : strstr(part, curves->part) != NULL;
}

/** The curves of one run; false: a table is damaged. */
static bool add_run(clod_figure *figure, const clod_run_files *run, size_t number,
                    const clod_series_curves *curves, clod_status *status)
{
    bool good = true;
    bool named = false;
    const char *part;
    for (size_t p = 0; good && (part = clod_run_files_part(run, p)) != NULL; p++) {
        clod_table table;
        char file[256];
        if (!is_shown(curves, part)) {
            continue;
        }
        snprintf(file, sizeof file, "%s.csv", part);
        good = clod_table_read(&table, run->folder, file, status);
        add_table(figure, &table, curves->over, curves->column, named ? "" : run->name, number);
        clod_table_fini(&table);
        named = true;
    }
    return good;
}

static void mark_run(clod_figure *figure, const clod_run_files *run, size_t number,
                     const clod_series_curves *curves)
{
    const char *part;
    for (size_t p = 0; (part = clod_run_files_part(run, p)) != NULL; p++) {
        if (is_shown(curves, part)) {
            curves->mark(figure, run, part, (int)number);
        }
    }
}

bool clod_series_compare_parts(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                               const clod_series_curves *curves, clod_status *status)
{
    clod_figure figure;
    char title[CLOD_FIGURE_TITLE], words[CLOD_FIGURE_NAME];
    clod_series_groups_words(curves->column, words);
    snprintf(title, sizeof title, "%c%s, %s", words[0] - 'a' + 'A', words + 1, curves->part);
    clod_figure_init(&figure, title, title);
    if (curves->behind != NULL) {
        snprintf(figure.title, sizeof figure.title, "%c%s, %s", words[0] - 'a' + 'A', words + 1,
                 curves->behind);
    }
    bool good = true;
    for (size_t r = 0; good && r < count; r++) {
        good = add_run(&figure, &runs[r], r, curves, status);
    }
    const size_t before = figure.count;
    for (size_t r = 0; good && curves->mark != NULL && r < count; r++) {
        mark_run(&figure, &runs[r], r, curves);
    }
    if (figure.count > before) {
        snprintf(figure.note, sizeof figure.note, "%s", curves->marks);
    }
    clod_sheet_figure(sheet, &figure);
    return good;
}

static void add_strengths(clod_figure *figure, const clod_run_files *run, size_t number,
                          double *largest)
{
    double x[MOST_STRESSES], y[MOST_STRESSES], error[MOST_STRESSES];
    size_t used = 0;
    size_t k;
    const json_t *one;
    json_array_foreach(json_object_get(run->summary, "flow_function"), k, one)
    {
        if (used < MOST_STRESSES) {
            x[used] = clod_shear_number(one, "sigma_1_Pa");
            y[used] = clod_shear_number(one, "sigma_c_Pa");
            error[used] = clod_shear_number(one, "sigma_c_error_Pa");
            *largest = fmax(*largest, isfinite(x[used]) ? x[used] : 0.0);
            used++;
        }
    }
    clod_figure_add(figure, run->name, CLOD_FIGURE_POINTS, (int)number, used, x, y, error);
}

bool clod_series_compare_strengths(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                                   clod_status *status)
{
    clod_figure figure;
    double largest = 0.0;
    clod_flow_figure_init(&figure);
    for (size_t r = 0; r < count; r++) {
        add_strengths(&figure, &runs[r], r, &largest);
    }
    clod_flow_figure_classes(&figure, largest);
    clod_sheet_figure(sheet, &figure);
    const clod_series_curves axial = {
        .part = "stress-", .over = "strain", .column = "axial_stress"};
    return clod_series_compare_parts(sheet, runs, count, &axial, status);
}

static bool is_compared(const char *name)
{
    for (size_t k = 0; k < sizeof FREE / sizeof *FREE; k++) {
        if (strcmp(clod_series_groups_quantity(name), FREE[k]) == 0) {
            return true;
        }
    }
    return false;
}

/** Whether a column of the first table is in all, and changes in one. */
static bool is_shared(const clod_table *tables, size_t count, const char *name)
{
    bool changes = false;
    for (size_t k = 0; k < count; k++) {
        const int at = clod_table_find(&tables[k], name);
        if (at < 0) {
            return false;
        }
        for (size_t r = 1; r < tables[k].rows && !changes; r++) {
            changes = strcmp(tables[k].cells[r * tables[k].columns + (size_t)at],
                             tables[k].cells[at]) != 0;
        }
    }
    return changes;
}

static void put_column(clod_sheet *sheet, const clod_run_files *runs, const clod_table *tables,
                       size_t count, const char *name)
{
    clod_figure figure;
    char whose[CLOD_FIGURE_NAME], title[CLOD_SERIES_GROUPS_TITLE];
    clod_series_groups_object(name, whose);
    clod_series_groups_title(clod_series_groups_quantity(name), whose, title);
    clod_figure_init(&figure, name, title);
    for (size_t k = 0; k < count; k++) {
        add_table(&figure, &tables[k], "time", name, runs[k].name, k);
    }
    clod_sheet_figure(sheet, &figure);
}

bool clod_series_compare_free(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                              clod_status *status)
{
    clod_table *tables = clod_memory_alloc(count, sizeof *tables);
    bool good = tables != NULL ||
                clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
    for (size_t k = 0; good && k < count; k++) {
        good = clod_table_read(&tables[k], runs[k].folder, "series.csv", status);
    }
    size_t figures = 0;
    for (size_t c = 0; good && c < tables[0].columns && figures < MOST_FIGURES; c++) {
        if (is_compared(tables[0].names[c]) && is_shared(tables, count, tables[0].names[c])) {
            put_column(sheet, runs, tables, count, tables[0].names[c]);
            figures++;
        }
    }
    for (size_t k = 0; tables != NULL && k < count; k++) {
        clod_table_fini(&tables[k]);
    }
    clod_memory_free(tables);
    return good;
}
