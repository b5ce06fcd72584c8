#include "report/wall_page.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "clod/wall_locus.h"
#include "report/cards.h"
#include "report/field_slices.h"
#include "report/html.h"
#include "report/part_curves.h"
#include "report/part_tables.h"
#include "report/rounded.h"
#include "report/shear_rows.h"

#define MOST_POINTS 512

typedef clod_wall_page_locus locus;

// ---- numbers

const clod_result_row CLOD_WALL_PAGE_ROWS[CLOD_WALL_PAGE_ROW_COUNT] = {
    {"phi_w_deg", "kinematic angle of wall friction", "phi_w", "deg", 1.0, 2, NULL, NULL,
     false},
    {"tau_ad_Pa", "wall adhesion", "tau_ad", "kPa", 1e-3, 3, NULL, NULL, false},
    {"r_squared", "fit of the line", "r\u00b2", "", 1.0, 4, NULL, "-", false},
};
#define CARDS 2 ///< of the rows

void clod_wall_page_cards(FILE *out, const json_t *from)
{
    for (size_t k = 0; from != NULL && k < CARDS; k++) {
        clod_cards_result(out, from, &CLOD_WALL_PAGE_ROWS[k], NULL);
    }
}

/** What the errors are. */
static bool has_errors(const json_t *of)
{
    const char *from = json_string_value(json_object_get(of, "errors_from"));
    return from == NULL || strcmp(from, "none") != 0;
}

static void put_notes(FILE *out, const clod_wall_page_locus *loci, size_t count)
{
    for (size_t s = 0; s < count; s++) {
        const char *note = json_string_value(json_object_get(loci[s].locus, "errors_note"));
        const double seeds = clod_shear_number(loci[s].locus, "seed_count");
        fputs("<p class=\"note\">", out);
        clod_html_text(out, loci[s].of);
        if (seeds > 1.0) {
            fprintf(out,
                    ": mean &plusmn; standard error of the mean, and scatter s (standard "
                    "deviation) of %.0f specimens.",
                    seeds);
        } else if (has_errors(loci[s].locus)) {
            fputs(
                ": &plusmn; one standard error, from scatter about the line and errors of the "
                "points",
                out);
            fputs(note != NULL ? "; <strong>" : ".", out);
            clod_html_text(out, note != NULL ? note : "");
            fputs(note != NULL ? "</strong>." : "", out);
        } else {
            fputs(": no error bars, which need three points, or the errors of the points.",
                  out);
        }
        fputs("</p>\n", out);
    }
}

/** A number of a point with its error, in a cell. */
static void put_cell(FILE *out, const json_t *point, const char *key, const char *error_key,
                     const char *unit, double factor, int digits)
{
    const double value = clod_shear_number(point, key);
    const double error = error_key != NULL ? clod_shear_number(point, error_key) : (double)NAN;
    clod_rounded_begin(out, "td", value, error, unit);
    if (isfinite(value)) {
        clod_rounded_put(clod_writer_page(out), factor * value, factor * error, (double)NAN,
                         digits, "");
    }
    fputs("</td>", out);
}

static void put_points(FILE *out, const clod_wall_page_locus *loci, size_t count)
{
    fputs(
        "<div class=\"scroll\"><table id=\"points-table\"><thead><tr><th>points</th>"
        "<th>seed</th><th>&sigma;<sub>w</sub> [kPa]</th><th>&tau;<sub>w</sub> [kPa]</th>"
        "<th>&phi;<sub>x</sub> [deg]</th><th>&tau; of the line [kPa]</th><th></th></tr></thead>\n"
        "<tbody>",
        out);
    for (size_t s = 0; s < count; s++) {
        size_t k;
        const json_t *p;
        json_array_foreach(json_object_get(loci[s].locus, "points"), k, p)
        {
            fputs("<tr>", out);
            clod_html_cell(out, "th", loci[s].of);
            const double seed = clod_shear_number(p, "seed");
            if (loci[s].lab && seed == 0.0) { // a laboratory has none
                fputs("<td></td>", out);
            } else {
                fprintf(out, "<td>%.0f</td>", seed);
            }
            put_cell(out, p, "sigma_w_Pa", "sigma_w_error_Pa", "Pa", 1e-3, 3);
            put_cell(out, p, "tau_w_Pa", "tau_w_error_Pa", "Pa", 1e-3, 3);
            put_cell(out, p, "phi_x_deg", "phi_x_error_deg", "deg", 1.0, 2);
            put_cell(out, p, "line_Pa", NULL, "Pa", 1e-3, 3);
            // pages of older runs have no such mark
            fputs(json_is_false(json_object_get(p, "steady")) ? "<td>not steady</td>"
                                                              : "<td></td>",
                  out);
            fputs("</tr>\n", out);
        }
    }
    fputs("</tbody></table></div>\n", out);
}

// ---- figures

/** The points of a locus over the wall normal stress; returns the largest of those. */
static double add_points(clod_figure *figure, const locus *from, const char *name,
                         const char *key, const char *error_key, int colour)
{
    double x[MOST_POINTS], y[MOST_POINTS], error[MOST_POINTS];
    double largest = 0.0;
    size_t used = 0;
    size_t k;
    const json_t *p;
    json_array_foreach(json_object_get(from->locus, "points"), k, p)
    {
        if (used < MOST_POINTS) {
            x[used] = clod_shear_number(p, "sigma_w_Pa");
            y[used] = clod_shear_number(p, key);
            error[used] = clod_shear_number(p, error_key);
            largest = fmax(largest, x[used++]);
        }
    }
    clod_figure_add(figure, name, from->lab ? CLOD_FIGURE_HOLLOW : CLOD_FIGURE_POINTS, colour,
                    used, x, y, error);
    return largest;
}

/** The fitted line, from the stress 0 on. */
static void add_line(clod_figure *figure, const locus *from, double end, int colour)
{
    const double slope = tan(
        clod_shear_number(json_object_get(from->locus, "phi_w_deg"), "value") * M_PI / 180.0);
    const double foot = clod_shear_number(json_object_get(from->locus, "tau_ad_Pa"), "value");
    const double begin = foot < 0.0 && slope > 0.0 ? -foot / slope : 0.0;
    const double x[2] = {begin, end};
    const double y[2] = {foot + slope * begin, foot + slope * end};
    clod_figure_add(figure, "", from->lab ? CLOD_FIGURE_DASHED : CLOD_FIGURE_LINE, colour, 2, x,
                    y, NULL);
}

void clod_wall_page_figures(clod_sheet *sheet, const clod_wall_page_locus *loci, size_t count)
{
    clod_figure line;
    clod_figure angle;
    clod_figure_init(&line, "wall-yield-locus", "Wall yield locus");
    clod_figure_axis_set(&line.x, "wall normal stress", "kPa", 1e-3);
    clod_figure_axis_set(&line.y, "wall shear stress", "kPa", 1e-3);
    line.equal = true;
    clod_figure_init(&angle, "wall-friction-angle", "Wall friction angle over stress");
    clod_figure_axis_set(&angle.x, "wall normal stress", "kPa", 1e-3);
    clod_figure_axis_set(&angle.y, "wall friction angle phi_x", "deg", 1.0);
    angle.from_zero = true;
    snprintf(line.note, sizeof line.note,
             "Both axes have the same scale. The line is fitted to the points; where it meets "
             "the shear stress axis is the wall adhesion.");
    for (size_t s = 0; s < count; s++) {
        const int colour = (int)s;
        const double end =
            add_points(&line, &loci[s], loci[s].of, "tau_w_Pa", "tau_w_error_Pa", colour);
        add_line(&line, &loci[s], end, colour);
        add_points(&angle, &loci[s], loci[s].of, "phi_x_deg", "phi_x_error_deg", colour);
    }
    clod_sheet_columns(sheet, true);
    clod_sheet_figure(sheet, &line);
    clod_sheet_figure(sheet, &angle);
    clod_sheet_columns(sheet, false);
}

static bool put_curves(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    static const clod_part_column COLUMNS[] = {
        {"shear_stress", "wall shear stress", "kPa", 1e-3},
        {"normal_stress", "wall normal stress", "kPa", 1e-3},
        {"height", "height of the specimen", "mm", 1e3},
        {"bulk_density", "bulk density", "kg/m3", 1.0},
    };
    const clod_part_curves curves = {
        .part = "wall",
        .over = {"displacement", "displacement of the plate", "mm", 1e3},
        .behind = "",
        .columns = COLUMNS,
        .count = sizeof COLUMNS / sizeof COLUMNS[0]};
    return clod_part_curves_put(sheet, run, &curves, status);
}

bool clod_wall_page_put(clod_sheet *sheet, const clod_run_files *run, const json_t *lab,
                        clod_status *status)
{
    locus loci[2] = {{.of = NULL}};
    size_t count = 0;
    const json_t *own = json_object_get(run->summary, "wall_locus");
    if (json_is_object(own)) {
        loci[count++] = (locus){.of = "simulation", .locus = own};
    }
    if (lab != NULL) {
        loci[count++] = (locus){.of = "laboratory", .locus = lab, .lab = true};
    }
    if (count > 0) {
        clod_html_section(sheet->body, "results", "Results");
        const clod_result_of of[2] = {{.name = loci[0].of, .from = loci[0].locus},
                                      {.name = loci[1].of, .from = loci[1].locus}};
        clod_result_table_put(clod_writer_page(sheet->body), CLOD_WALL_PAGE_ROWS,
                              CLOD_WALL_PAGE_ROW_COUNT, of, count);
        put_notes(sheet->body, loci, count);
        clod_wall_page_figures(sheet, loci, count);
        put_points(sheet->body, loci, count);
    }
    clod_html_section(sheet->body, "curves", "Curves of the test");
    clod_sheet_columns(sheet, true);
    const bool good = put_curves(sheet, run, status);
    clod_sheet_columns(sheet, false);
    return good && clod_field_slices_put(sheet, run, status) &&
           clod_part_tables_put(sheet, run, status);
}

// ---- laboratory

json_t *clod_wall_page_lab(const char *path, clod_status *status)
{
    clod_wall_locus_point *points;
    clod_wall_locus made = {0};
    size_t count;
    if (!clod_wall_locus_read(path, &points, &count, status)) {
        return NULL;
    }
    clod_status why = {0};
    const bool good = clod_wall_locus_of_table(points, count, &made, &why) ||
                      clod_status_fail(status, why.code, "%s: %s", path, why.text);
    clod_locus_free(points);
    char *text = good ? clod_wall_locus_json(&made) : NULL;
    json_t *all = text != NULL ? json_loads(text, 0, NULL) : NULL;
    if (good && all == NULL) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the laboratory's points.");
    }
    clod_locus_free(text);
    clod_wall_locus_fini(&made);
    return all;
}
