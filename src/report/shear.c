#include "report/shear.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "report/html.h"
#include "report/shear_rows.h"

double clod_shear_number(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    if (json_is_object(value)) {
        value = json_object_get(value, "value");
    }
    return json_is_number(value) ? json_number_value(value) : (double)NAN;
}

static double part_of(const json_t *locus, const char *key, const char *part)
{
    return clod_shear_number(json_object_get(locus, key), part);
}

const clod_shear_row CLOD_SHEAR_ROWS[CLOD_SHEAR_ROW_COUNT] = {
    {"sigma_p_Pa", "preshear normal stress", "&sigma;<sub>pre</sub>", "kPa", 1e-3, 3},
    {"tau_p_Pa", "preshear shear stress", "&tau;<sub>pre</sub>", "kPa", 1e-3, 3},
    {"sigma_1_Pa", "major principal stress", "&sigma;<sub>1</sub>", "kPa", 1e-3, 3},
    {"sigma_2_Pa", "minor principal stress", "&sigma;<sub>2</sub>", "kPa", 1e-3, 3},
    {"sigma_c_Pa", "unconfined yield strength", "&sigma;<sub>c</sub>", "kPa", 1e-3, 3},
    {"ffc", "flowability &sigma;<sub>1</sub>/&sigma;<sub>c</sub>", "ff<sub>c</sub>", "", 1.0,
     2},
    {"c_Pa", "cohesion", "c", "kPa", 1e-3, 3},
    {"phi_lin_deg", "angle of the yield locus", "&phi;<sub>lin</sub>", "deg", 1.0, 2},
    {"phi_e_deg", "effective angle of friction", "&phi;<sub>e</sub>", "deg", 1.0, 2},
    {"phi_sf_deg", "angle of friction at steady flow", "&phi;<sub>sf</sub>", "deg", 1.0, 2},
    {"rho_b_kg_m3", "bulk density", "&rho;<sub>b</sub>", "kg/m&sup3;", 1.0, 1},
};

const clod_shear_row *clod_shear_row_of(const char *key)
{
    size_t k = 0;
    while (strcmp(CLOD_SHEAR_ROWS[k].key, key) != 0) {
        k++;
    }
    return &CLOD_SHEAR_ROWS[k];
}

void clod_shear_value(FILE *out, const json_t *locus, const clod_shear_row *row)
{
    const double value = clod_shear_number(locus, row->key);
    const double error = part_of(locus, row->key, "error");
    const double scatter = part_of(locus, row->key, "scatter");
    if (!isfinite(value)) {
        fputs(row == clod_shear_row_of("rho_b_kg_m3") ? "not given" : "undefined", out);
        return;
    }
    fprintf(out, "%.*f", row->digits, row->factor * value);
    if (isfinite(error) && error > 0.0) {
        fprintf(out, " <small>&plusmn; %.*f</small>", row->digits, row->factor * error);
    }
    if (isfinite(scatter)) {
        fprintf(out, " <small>(s %.*f)</small>", row->digits, row->factor * scatter);
    }
}

const json_t *clod_shear_locus(const json_t *study, size_t g)
{
    return json_array_get(json_object_get(study, "loci"), g);
}

void clod_shear_warnings(FILE *out, const json_t *study)
{
    const json_t *locus;
    for (size_t g = 0; (locus = clod_shear_locus(study, g)) != NULL; g++) {
        size_t k;
        const json_t *text;
        json_array_foreach(json_object_get(locus, "warnings"), k, text)
        {
            clod_html_cell(out, "li", json_string_value(text));
        }
    }
    size_t k;
    const json_t *text;
    json_array_foreach(json_object_get(study, "warnings"), k, text)
    {
        clod_html_cell(out, "li", json_string_value(text));
    }
}

static void put_flow(FILE *out, const clod_shear_loci *sets, size_t count)
{
    fputs("<tr><th>flow (Jenike)</th><td></td>", out);
    for (size_t s = 0; s < count; s++) {
        const json_t *locus;
        for (size_t g = 0; (locus = clod_shear_locus(sets[s].study, g)) != NULL; g++) {
            clod_html_cell(out, "td", json_string_value(json_object_get(locus, "flow")));
        }
    }
    fputs("<td></td></tr>\n<tr><th>fit of the line</th><td>r&sup2;</td>", out);
    for (size_t s = 0; s < count; s++) {
        const json_t *locus;
        for (size_t g = 0; (locus = clod_shear_locus(sets[s].study, g)) != NULL; g++) {
            fprintf(out, "<td>%.4f</td>", clod_shear_number(locus, "r_squared"));
        }
    }
    fputs("<td></td></tr>\n", out);
}

/** What the errors are, of each set. */
static void put_notes(FILE *out, const clod_shear_loci *sets, size_t count)
{
    for (size_t s = 0; s < count; s++) {
        const json_t *locus = clod_shear_locus(sets[s].study, 0);
        const char *from = json_string_value(json_object_get(locus, "errors_from"));
        const char *note = json_string_value(json_object_get(locus, "errors_note"));
        fputs("<p class=\"note\">", out);
        clod_html_text(out, sets[s].of);
        if (from != NULL && strcmp(from, "seeds") == 0) {
            fprintf(out,
                    ": mean &plusmn; standard error of the mean, and scatter s (standard "
                    "deviation) of %.0f specimens.",
                    clod_shear_number(locus, "seed_count"));
        } else if (from != NULL && strcmp(from, "fit") == 0) {
            fputs(
                ": &plusmn; one standard error, from scatter about the line and errors of the "
                "points",
                out);
            fputs(note != NULL ? "; <strong>" : ".", out);
            clod_html_text(out, note != NULL ? note : "");
            fputs(note != NULL ? "</strong>." : "", out);
        } else {
            fputs(": no error bars; they need three points, or the errors of the points.", out);
        }
        fputs("</p>\n", out);
    }
}

void clod_shear_table(FILE *out, const clod_shear_loci *sets, size_t count)
{
    fputs("<div class=\"scroll\"><table class=\"results\" id=\"results-table\"><thead><tr><th>"
          "quantity</th><th></th>",
          out);
    for (size_t s = 0; s < count; s++) {
        for (size_t g = 0; clod_shear_locus(sets[s].study, g) != NULL; g++) {
            clod_html_cell(out, "th", sets[s].of);
        }
    }
    fputs("<th>unit</th></tr></thead>\n<tbody>", out);
    for (size_t k = 0; k < CLOD_SHEAR_ROW_COUNT; k++) {
        const clod_shear_row *row = &CLOD_SHEAR_ROWS[k];
        fprintf(out, "<tr><th>%s</th><td>%s</td>", row->text, row->symbol);
        for (size_t s = 0; s < count; s++) {
            const json_t *locus;
            for (size_t g = 0; (locus = clod_shear_locus(sets[s].study, g)) != NULL; g++) {
                fputs("<td>", out);
                clod_shear_value(out, locus, row);
                fputs("</td>", out);
            }
        }
        fprintf(out, "<td>%s</td></tr>\n", row->unit);
    }
    put_flow(out, sets, count);
    fputs("</tbody></table></div>\n", out);
    put_notes(out, sets, count);
}

void clod_shear_points(FILE *out, const clod_shear_loci *sets, size_t count)
{
    fputs("<div class=\"scroll\"><table id=\"points-table\"><thead><tr><th>shear points</th>"
          "<th>&sigma;<sub>pre</sub></th><th>&sigma;</th>"
          "<th>&tau;</th><th>&tau; prorated</th><th>&tau; of the line</th><th>unit</th></tr>"
          "</thead>\n<tbody>",
          out);
    for (size_t s = 0; s < count; s++) {
        const json_t *locus;
        for (size_t g = 0; (locus = clod_shear_locus(sets[s].study, g)) != NULL; g++) {
            size_t k;
            const json_t *point;
            json_array_foreach(json_object_get(locus, "points"), k, point)
            {
                fputs("<tr>", out);
                clod_html_cell(out, "th", sets[s].of);
                fprintf(out,
                        "<td>%.3f</td><td>%.3f</td><td>%.3f</td><td>%.3f</td><td>%.3f</td><td>"
                        "kPa</td></tr>\n",
                        1e-3 * clod_shear_number(locus, "sigma_p_Pa"),
                        1e-3 * clod_shear_number(point, "sigma_s_Pa"),
                        1e-3 * clod_shear_number(point, "tau_s_Pa"),
                        1e-3 * clod_shear_number(point, "prorated_Pa"),
                        1e-3 * clod_shear_number(point, "line_Pa"));
            }
        }
    }
    fputs("</tbody></table></div>\n", out);
}

bool clod_shear_put(clod_sheet *sheet, const clod_run_files *run, const json_t *lab,
                    clod_status *status)
{
    clod_shear_loci sets[2];
    size_t count = 0;
    const json_t *study = json_object_get(run->summary, "locus");
    if (study != NULL) {
        sets[count++] = (clod_shear_loci){.of = "simulation", .study = study};
    }
    if (lab != NULL) {
        sets[count++] = (clod_shear_loci){.of = "laboratory", .study = lab, .lab = true};
    }
    if (count > 0) {
        clod_html_section(sheet->body, "results", "Results");
        clod_shear_table(sheet->body, sets, count);
        clod_shear_figures(sheet, sets, count);
        clod_shear_points(sheet->body, sets, count);
    }
    clod_html_section(sheet->body, "curves", "Curves of the test");
    clod_sheet_columns(sheet, true);
    const bool good = clod_shear_curves(sheet, run, status);
    clod_sheet_columns(sheet, false);
    return good;
}
