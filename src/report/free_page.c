#include "report/run_pages.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "report/field_axes.h"
#include "report/field_slices.h"
#include "report/free_tables.h"
#include "report/html.h"
#include "report/series_figures.h"
#include "report/summary_tables.h"
#include "report/table.h"

/** The tables of a page. */
static void put_tables(FILE *out, const json_t *summary)
{
    clod_html_section(out, "tables", "Tables");
    for (size_t k = 0; k < CLOD_FREE_TABLE_COUNT; k++) {
        const clod_free_table *table = &CLOD_FREE_TABLES[k];
        json_t *objects = clod_free_tables_of(table, summary);
        clod_summary_tables_put(out, table->title, table->spread, objects);
        json_decref(objects);
    }
}

/** The numbers of a column by its name, owned; NULL when there is none, or no memory. */
static double *numbers_of(const clod_table *table, const char *name)
{
    const int at = clod_table_find(table, name);
    return at >= 0 ? clod_table_numbers(table, at) : NULL;
}

/** Lower, mean and upper border of a stream over the first column. */
static void put_stream(clod_sheet *sheet, const clod_table *table, const char *gauge,
                       const char *what)
{
    static const char *const BORDERS[] = {"lower", "mean", "upper"};
    char name[160], title[160];
    clod_figure figure;
    snprintf(name, sizeof name, "gauge-%s-%s", gauge, what);
    snprintf(title, sizeof title, "Gauge %s: %s of the stream", gauge, what);
    clod_figure_init(&figure, name, title);
    clod_figure_axis_set(&figure.x, table->names[0], table->units[0], 1.0);
    clod_figure_axis_set(&figure.y, "place of the borders", "m", 1.0);
    double *x = clod_table_numbers(table, 0);
    for (int k = 0; x != NULL && k < 3; k++) {
        double *y = numbers_of(table, BORDERS[k]);
        if (y != NULL) {
            clod_figure_add(&figure, BORDERS[k], k == 1 ? CLOD_FIGURE_LINE : CLOD_FIGURE_DASHED,
                            k, table->rows, x, y, NULL);
        }
        clod_memory_free(y);
    }
    clod_memory_free(x);
    clod_sheet_figure(sheet, &figure);
}

static bool put_streams(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    static const char *const WHAT[] = {"profile", "trajectory"};
    bool good = true;
    const char *gauge;
    json_t *value;
    json_object_foreach(json_object_get(run->summary, "gauges"), gauge, value)
    {
        for (int k = 0; good && k < 2; k++) {
            clod_table table;
            char name[256];
            snprintf(name, sizeof name, "gauge_%s-%s.csv", gauge, WHAT[k]);
            good = clod_table_read(&table, run->folder, name, status);
            if (good && table.columns > 0) {
                put_stream(sheet, &table, gauge, WHAT[k]);
            }
            clod_table_fini(&table);
        }
    }
    return good;
}

/** How the mass is spread over the sizes of clumps, for each count. */
static void put_clumps(clod_sheet *sheet, const clod_table *table)
{
    double *x = numbers_of(table, "to"), *y = numbers_of(table, "share");
    clod_figure figure;
    clod_figure_init(&figure, "clumps", "Sizes of clumps, by mass");
    clod_figure_axis_set(&figure.x, "grains of a clump, up to", "", 1.0);
    clod_figure_axis_set(&figure.y, "share of the mass in this class", "%", 100.0);
    figure.log_x = true;
    int number = 0;
    for (size_t from = 0, r = 1; x != NULL && y != NULL && r <= table->rows; r++) {
        const char *count = table->cells[from * table->columns];
        if (r == table->rows || strcmp(table->cells[r * table->columns], count) != 0) {
            clod_figure_add(&figure, count, CLOD_FIGURE_LINE, number++, r - from, x + from,
                            y + from, NULL);
            from = r;
        }
    }
    clod_memory_free(x);
    clod_memory_free(y);
    clod_sheet_figure(sheet, &figure);
}

/** Which share of the grains that left was in for how long at most. */
static void put_residence(clod_sheet *sheet, const clod_table *table)
{
    double *x = numbers_of(table, "to"), *y = numbers_of(table, "share_up_to");
    clod_figure figure;
    clod_figure_init(&figure, "residence", "Residence time of what left");
    clod_figure_axis_set(&figure.x, "time inside, up to", "s", 1.0);
    clod_figure_axis_set(&figure.y, "share of the grains", "%", 100.0);
    if (x != NULL && y != NULL) {
        clod_figure_add(&figure, "share", CLOD_FIGURE_LINE, 0, table->rows, x, y, NULL);
    }
    clod_memory_free(x);
    clod_memory_free(y);
    clod_sheet_figure(sheet, &figure);
}

/** The figure of a table of its own, when the run has it. */
static bool put_one(clod_sheet *sheet, const clod_run_files *run, const char *name,
                    void (*put)(clod_sheet *, const clod_table *), clod_status *status)
{
    clod_table table;
    const bool good = clod_table_read(&table, run->folder, name, status);
    if (good && table.rows > 0) {
        put(sheet, &table);
    }
    clod_table_fini(&table);
    return good;
}

static void put_ledger(clod_sheet *sheet, const clod_table *table)
{
    clod_series_figures_all(sheet, table, "energy-ledger", "Energy ledger", "J");
}

/** The figures that need tables of their own. */
static bool put_others(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    return put_streams(sheet, run, status) &&
           put_one(sheet, run, "residence.csv", put_residence, status) &&
           put_one(sheet, run, "clumps.csv", put_clumps, status) &&
           put_one(sheet, run, "energy.csv", put_ledger, status);
}

bool clod_run_pages_free(clod_sheet *sheet, const clod_run_files *run, const json_t *lab,
                         clod_status *status)
{
    (void)lab;
    clod_table series;
    bool good = clod_table_read(&series, run->folder, "series.csv", status);
    if (good) {
        clod_html_section(sheet->body, "curves", "Curves over time");
        clod_sheet_columns(sheet, true);
        clod_series_figures_put(sheet, &series, true);
        good = put_others(sheet, run, status);
        clod_sheet_columns(sheet, false);
        fputs("<details class=\"more\"><summary>More curves</summary>\n", sheet->body);
        clod_sheet_columns(sheet, true);
        clod_series_figures_put(sheet, &series, false);
        clod_sheet_columns(sheet, false);
        fputs("</details>\n", sheet->body);
        good = good && clod_field_slices_put(sheet, run, status);
        clod_field_axes_set(run);
        put_tables(sheet->body, run->summary);
    }
    clod_table_fini(&series);
    return good;
}
