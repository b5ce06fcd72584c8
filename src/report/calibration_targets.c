/**
 * @file calibration_targets.c
 * Targets over the parameters: runs, surrogates, what was measured.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/calibration_figures.h"
#include "report/html.h"
#include "report/shear_rows.h"
#include "report/table.h"

#define GRID 201 ///< points of a section, at most

/** Numbers of a JSON list; how many. */
static size_t take(const json_t *list, double to[GRID])
{
    size_t count = 0;
    size_t k;
    const json_t *one;
    json_array_foreach(list, k, one)
    {
        if (count < GRID) {
            to[count++] = json_is_number(one) ? json_number_value(one) : (double)NAN;
        }
    }
    return count;
}

/** The surrogate along a parameter, the others at their means, and two deviations to both sides. */
static void add_section(clod_figure *figure, const json_t *section)
{
    double x[GRID], mean[GRID], deviation[GRID], low[GRID], high[GRID];
    const size_t count = take(json_object_get(section, "at"), x);
    if (count == 0 || take(json_object_get(section, "mean"), mean) != count ||
        take(json_object_get(section, "deviation"), deviation) != count) {
        return;
    }
    for (size_t i = 0; i < count; i++) {
        low[i] = mean[i] - 2.0 * deviation[i];
        high[i] = mean[i] + 2.0 * deviation[i];
    }
    clod_figure_add(figure, "surrogate", CLOD_FIGURE_LINE, 0, count, x, mean, NULL);
    clod_figure_add(figure, "two deviations", CLOD_FIGURE_DOTTED, 0, count, x, low, NULL);
    clod_figure_add(figure, "", CLOD_FIGURE_DOTTED, 0, count, x, high, NULL);
}

/** Points of the runs; x and y are the columns with these names, which stand without their units. */
static void add_runs(clod_figure *figure, const clod_table *runs, const char *parameter,
                     const char *target)
{
    const int at = clod_table_find(runs, parameter);
    const int of = clod_table_find(runs, target);
    double *x = at >= 0 ? clod_table_numbers(runs, at) : NULL;
    double *y = of >= 0 ? clod_table_numbers(runs, of) : NULL;
    if (x != NULL && y != NULL) {
        clod_figure_add(figure, "runs", CLOD_FIGURE_POINTS, 1, runs->rows, x, y, NULL);
    }
    clod_memory_free(x);
    clod_memory_free(y);
}

/** A target over a parameter: runs, surrogate, measured value with its error. */
static void put_figure(clod_sheet *sheet, const clod_table *runs, const json_t *target,
                       const char *parameter, const json_t *about)
{
    char title[CLOD_FIGURE_TITLE], of[CLOD_FIGURE_NAME], over[64];
    clod_figure figure;
    const char *name = json_string_value(json_object_get(target, "name"));
    clod_text_fit(of, sizeof of, sizeof of, name, strlen(name));
    clod_text_fit(over, sizeof over, sizeof over, parameter, strlen(parameter));
    snprintf(title, sizeof title, "%s over %s", of, over);
    clod_figure_init(&figure, "target", title);
    const char *unit = json_string_value(json_object_get(about, "unit"));
    const char *measured_in = json_string_value(json_object_get(target, "unit"));
    clod_figure_axis_set(&figure.x, parameter, unit != NULL ? unit : "", 1.0);
    clod_figure_axis_set(&figure.y, name, measured_in != NULL ? measured_in : "", 1.0);
    const char *scale = json_string_value(json_object_get(about, "scale"));
    figure.log_x = scale != NULL && strcmp(scale, "log") == 0;
    add_section(&figure, json_object_get(
                             json_object_get(json_object_get(target, "surrogate"), "sections"),
                             parameter));
    add_runs(&figure, runs, parameter, name);
    const double x[2] = {clod_shear_number(about, "from"), clod_shear_number(about, "to")};
    const double value = clod_shear_number(target, "measured");
    const double error = clod_shear_number(target, "error");
    const double y[3][2] = {
        {value, value}, {value - error, value - error}, {value + error, value + error}};
    clod_figure_add(&figure, "measured", CLOD_FIGURE_LINE, CLOD_FIGURE_GREY, 2, x, y[0], NULL);
    clod_figure_add(&figure, "its error", CLOD_FIGURE_DASHED, CLOD_FIGURE_GREY, 2, x, y[1],
                    NULL);
    clod_figure_add(&figure, "", CLOD_FIGURE_DASHED, CLOD_FIGURE_GREY, 2, x, y[2], NULL);
    clod_sheet_figure(sheet, &figure);
}

bool clod_calibration_figures_targets(clod_sheet *sheet, const char *folder,
                                      const json_t *result, clod_status *status)
{
    clod_table runs;
    size_t t;
    const json_t *target;
    const char *parameter;
    const json_t *about;
    const bool good = clod_table_read(&runs, folder, "runs.csv", status);
    clod_html_section(sheet->body, "targets", "Targets over parameters");
    clod_sheet_columns(sheet, true);
    json_array_foreach(json_object_get(result, "targets"), t, target)
    {
        json_object_foreach(json_object_get(result, "parameters"), parameter, about)
        {
            if (good) {
                put_figure(sheet, &runs, target, parameter, about);
            }
        }
    }
    clod_sheet_columns(sheet, false);
    fputs(
        "<p class=\"note\">Points: one packing each, wherever the other parameters were. Line: the "
        "surrogate, the other parameters at their means.</p>\n",
        sheet->body);
    clod_table_fini(&runs);
    return good;
}
