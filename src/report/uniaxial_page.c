#include "report/run_pages.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "clod/locus.h"
#include "report/flow_figure.h"
#include "report/html.h"
#include "report/shear_rows.h"
#include "report/summary_tables.h"
#include "report/table.h"

#define MOST_STRESSES 64

static void put_flow_function(clod_sheet *sheet, const json_t *strengths)
{
    double x[MOST_STRESSES], y[MOST_STRESSES], error[MOST_STRESSES];
    size_t count = 0;
    double largest = 0.0;
    size_t k;
    const json_t *one;
    clod_figure figure;
    clod_flow_figure_init(&figure);
    json_array_foreach(strengths, k, one)
    {
        if (count < MOST_STRESSES) {
            x[count] = clod_shear_number(one, "sigma_1_Pa");
            y[count] = clod_shear_number(one, "sigma_c_Pa");
            error[count] = clod_shear_number(one, "sigma_c_error_Pa");
            largest = fmax(largest, isfinite(x[count]) ? x[count] : 0.0);
            count++;
        }
    }
    clod_figure_add(&figure, "simulation", CLOD_FIGURE_POINTS, 0, count, x, y, error);
    clod_flow_figure_classes(&figure, largest);
    clod_sheet_figure(sheet, &figure);
}

/** What is drawn over strain. */
static const struct {
    const char *column, *text, *unit;
    double factor;
} CURVES[] = {{"axial_stress", "axial stress", "kPa", 1e-3},
              {"bulk_density", "bulk density", "kg/m3", 1.0}};
#define CURVE_COUNT (sizeof CURVES / sizeof CURVES[0])

/** Add a part's curves to the figures; false: its table is damaged. */
static bool add_part(clod_figure *figures, const clod_run_files *run, const char *part,
                     int number, clod_status *status)
{
    clod_table table;
    char name[256];
    snprintf(name, sizeof name, "%s.csv", part);
    const bool good = clod_table_read(&table, run->folder, name, status);
    const int at = good ? clod_table_find(&table, "strain") : -1;
    double *x = at >= 0 ? clod_table_numbers(&table, at) : NULL;
    const size_t first = x != NULL ? clod_figure_begin(x, table.rows) : 0;
    for (size_t q = 0; x != NULL && q < CURVE_COUNT; q++) {
        const int column = clod_table_find(&table, CURVES[q].column);
        double *y = column >= 0 ? clod_table_numbers(&table, column) : NULL;
        if (y != NULL) {
            clod_figure_add(&figures[q], part, CLOD_FIGURE_LINE, number % CLOD_FIGURE_COLOURS,
                            table.rows - first, x + first, y + first, NULL);
        }
        clod_memory_free(y);
    }
    clod_memory_free(x);
    clod_table_fini(&table);
    return good;
}

static bool put_curves(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    clod_figure figures[CURVE_COUNT];
    for (size_t q = 0; q < CURVE_COUNT; q++) {
        char title[128];
        snprintf(title, sizeof title, "%c%s over strain", CURVES[q].text[0] - 'a' + 'A',
                 CURVES[q].text + 1);
        clod_figure_init(&figures[q], CURVES[q].column, title);
        clod_figure_axis_set(&figures[q].x, "axial strain", "%", 100.0);
        clod_figure_axis_set(&figures[q].y, CURVES[q].text, CURVES[q].unit, CURVES[q].factor);
    }
    bool good = true;
    int number = 0;
    const char *part;
    for (size_t p = 0; good && (part = clod_run_files_part(run, p)) != NULL; p++) {
        good =
            strstr(part, "stress-") == NULL || add_part(figures, run, part, number++, status);
    }
    for (size_t q = 0; q < CURVE_COUNT; q++) {
        clod_sheet_figure(sheet, &figures[q]);
    }
    return good;
}

bool clod_run_pages_uniaxial(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    json_t *strengths = json_object_get(run->summary, "flow_function");
    clod_html_section(sheet->body, "results", "Results");
    clod_summary_tables_put(sheet->body, NULL, strengths);
    if (json_object_get(json_array_get(strengths, 0), "errors_note") != NULL) {
        fputs(
            "<p class=\"note\">&plusmn; one standard error of the smoothed peak; <strong>" CLOD_LOCUS_ONE_SPECIMEN
            "</strong>.</p>\n",
            sheet->body);
    }
    clod_sheet_columns(sheet, true);
    put_flow_function(sheet, strengths);
    const bool good = put_curves(sheet, run, status);
    clod_sheet_columns(sheet, false);
    return good;
}
