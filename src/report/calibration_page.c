#include "report/calibration_page.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/input.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "report/html.h"
#include "report/shear_rows.h"
#include "report/table.h"

#define MOST_BYTES ((size_t)1 << 26)
#define GRID 201 ///< points of a section, at most

/** A column of a table: a key of an object, or a text of it. */
typedef struct column {
    const char *key, *head;
} column;

static const column PARAMETERS[] = {{"mean", "mean"},
                                    {"low", "low"},
                                    {"high", "high"},
                                    {"unit", "unit"},
                                    {"from", "range from"},
                                    {"to", "to"},
                                    {"scale", "scale"},
                                    {"relative_width", "width over the range's"},
                                    {"identified", "identified by the targets"},
                                    {"rhat", "R-hat"},
                                    {"effective_samples", "independent samples"}};
static const column TARGETS[] = {{"measured", "measured"},
                                 {"error", "error"},
                                 {"discrepancy", "discrepancy"},
                                 {"model", "model"},
                                 {"low", "low"},
                                 {"high", "high"},
                                 {"unit", "unit"},
                                 {"off", "off, in deviations"}};
static const column SURROGATES[] = {{"kind", "surrogate"},
                                    {"runs", "runs"},
                                    {"packing_deviation", "between packings"},
                                    {"left_out_error", "error of left-out points"},
                                    {"q2", "Q2"},
                                    {"within_two_deviations", "within two deviations"}};
#define COUNT(columns) (sizeof(columns) / sizeof((columns)[0]))

bool clod_calibration_page_is(const char *folder)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/calibration.json", folder);
    return access(path, F_OK) == 0;
}

static void put_heads(FILE *out, const char *first, const column *columns, size_t count)
{
    fputs("<div class=\"scroll\"><table><thead><tr>", out);
    clod_html_cell(out, "th", first);
    for (size_t k = 0; k < count; k++) {
        clod_html_cell(out, "th", columns[k].head);
    }
    fputs("</tr></thead>\n<tbody>", out);
}

static void put_row(FILE *out, const char *name, const json_t *from, const column *columns,
                    size_t count)
{
    fputs("<tr>", out);
    clod_html_cell(out, "th", name);
    for (size_t k = 0; k < count; k++) {
        const json_t *value = json_object_get(from, columns[k].key);
        char number[48] = "";
        if (json_is_number(value)) {
            snprintf(number, sizeof number, "%.4g", json_number_value(value));
        }
        clod_html_cell(out, "td", json_is_string(value) ? json_string_value(value) : number);
    }
    fputs("</tr>\n", out);
}

/** "ring: phi_e", as the columns of runs.csv have it, without the unit. */
static const char *name_of(const json_t *target)
{
    return json_string_value(json_object_get(target, "name"));
}

/** Whether targets have their names; clod wrote none before. */
static bool check_names(const json_t *result, const char *folder, clod_status *status)
{
    size_t k;
    const json_t *target;
    json_array_foreach(json_object_get(result, "targets"), k, target)
    {
        if (name_of(target) == NULL) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "%s/calibration.json: target %zu has no name, so another "
                                    "version of clod wrote it. Calibrate anew, in another "
                                    "folder.",
                                    folder, k + 1);
        }
    }
    return true;
}

static void put_targets(FILE *out, const json_t *result, bool held_back, const char *title)
{
    size_t k;
    const json_t *target;
    bool begun = false;
    json_array_foreach(json_object_get(result, "targets"), k, target)
    {
        if (json_is_true(json_object_get(target, "held_back")) != held_back) {
            continue;
        }
        if (!begun) {
            fprintf(out, "<h3>%s</h3>\n", title);
            put_heads(out, "target", TARGETS, COUNT(TARGETS));
        }
        begun = true;
        put_row(out, name_of(target), target, TARGETS, COUNT(TARGETS));
    }
    fputs(begun ? "</tbody></table></div>\n" : "", out);
}

static void put_tables(FILE *out, const json_t *result)
{
    const char *name;
    const json_t *one;
    size_t k;
    clod_html_section(out, "results", "Results");
    put_heads(out, "parameter", PARAMETERS, COUNT(PARAMETERS));
    json_object_foreach(json_object_get(result, "parameters"), name, one)
    {
        put_row(out, name, one, PARAMETERS, COUNT(PARAMETERS));
    }
    fputs("</tbody></table></div>\n", out);
    put_targets(out, result, false, "Targets that were used");
    put_targets(out, result, true, "Targets that were held back, predicted");
    fprintf(
        out,
        "<p class=\"note\">low and high: %.3g %% intervals; of a target, of what a laboratory "
        "would measure. Posterior predictive p = %.2g, chi-square %.3g.</p>\n",
        100.0 * clod_shear_number(result, "level"), clod_shear_number(result, "p_value"),
        clod_shear_number(result, "chi_square"));
    fputs("<h3>Surrogates, each point predicted by the others</h3>\n", out);
    put_heads(out, "target", SURROGATES, COUNT(SURROGATES));
    json_array_foreach(json_object_get(result, "targets"), k, one)
    {
        put_row(out, name_of(one), json_object_get(one, "surrogate"), SURROGATES,
                COUNT(SURROGATES));
    }
    fputs("</tbody></table></div>\n", out);
}

static void put_warnings(FILE *out, const json_t *result)
{
    const json_t *warnings = json_object_get(result, "warnings");
    size_t k;
    const json_t *one;
    if (json_array_size(warnings) == 0) {
        fputs("<p class=\"good\">No warnings.</p>\n", out);
        return;
    }
    fputs("<section class=\"warnings\" id=\"warnings\"><h2>Warnings</h2><ul>", out);
    json_array_foreach(warnings, k, one)
    {
        clod_html_cell(out, "li", json_is_string(one) ? json_string_value(one) : "");
    }
    fputs("</ul></section>\n", out);
}

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
    const char *name = name_of(target);
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

static bool put_figures(clod_sheet *sheet, const char *folder, const json_t *result,
                        clod_status *status)
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

/** Report and card as they are. */
static void put_texts(FILE *out, const char *folder)
{
    static const char *const FILES[] = {"report.txt", "card.yaml", "plan.yaml"};
    for (size_t k = 0; k < sizeof FILES / sizeof FILES[0]; k++) {
        char path[PATH_MAX];
        char *text;
        size_t length;
        clod_status none = {CLOD_OK, ""};
        snprintf(path, sizeof path, "%s/%s", folder, FILES[k]);
        if (clod_input_read_regular(path, MOST_BYTES, &text, &length, &none)) {
            clod_html_folded(out, FILES[k], text);
            clod_memory_free(text);
        }
    }
}

bool clod_calibration_page_put(clod_sheet *sheet, const char *folder, char **title,
                               clod_status *status)
{
    *title = NULL;
    json_t *result = clod_json_read(folder, "calibration.json", status);
    if (result == NULL || !check_names(result, folder, status)) {
        json_decref(result);
        return false;
    }
    const char *named = json_string_value(json_object_get(result, "title"));
    *title = clod_memory_text(named != NULL ? named : folder);
    bool good = *title != NULL ||
                clod_status_fail(status, CLOD_FAILED, "No memory for the title of the page.");
    fputs("<header><p class=\"kind\">Calibration</p><h1>", sheet->body);
    clod_html_text(sheet->body, *title != NULL ? *title : "");
    fputs("</h1><p class=\"when\">", sheet->body);
    clod_html_text(sheet->body, folder);
    fputs("</p></header>\n", sheet->body);
    put_warnings(sheet->body, result);
    put_tables(sheet->body, result);
    good = good && put_figures(sheet, folder, result, status);
    put_texts(sheet->body, folder);
    json_decref(result);
    return good;
}
