#include "report/shear.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "report/field_slices.h"
#include "report/html.h"
#include "report/part_tables.h"
#include "report/shear_points.h"
#include "report/shear_rows.h"

double clod_shear_number(const json_t *object, const char *key)
{
    return clod_result_table_number(object, key);
}

const clod_result_row CLOD_SHEAR_ROWS[CLOD_SHEAR_ROW_COUNT] = {
    {"sigma_p_Pa", "preshear normal stress", "sigma_pre", "kPa", 1e-3, 3, NULL, NULL, false},
    {"tau_p_Pa", "preshear shear stress", "tau_pre", "kPa", 1e-3, 3, NULL, NULL, false},
    {"sigma_1_Pa", "major principal stress", "sigma_1", "kPa", 1e-3, 3, NULL, NULL, false},
    {"sigma_2_Pa", "minor principal stress", "sigma_2", "kPa", 1e-3, 3, NULL, NULL, false},
    {"sigma_c_Pa", "unconfined yield strength", "sigma_c", "kPa", 1e-3, 3, NULL, NULL, false},
    {"ffc", "flowability $sigma_1$/$sigma_c$", "ff_c", "", 1.0, 2, NULL, NULL, false},
    {"c_Pa", "cohesion", "c", "kPa", 1e-3, 3, NULL, NULL, false},
    {"phi_lin_deg", "angle of the yield locus", "phi_lin", "deg", 1.0, 2, NULL, NULL, false},
    {"phi_e_deg", "effective angle of friction", "phi_e", "deg", 1.0, 2, NULL, NULL, false},
    {"phi_sf_deg", "angle of friction at steady flow", "phi_sf", "deg", 1.0, 2, NULL, NULL,
     false},
    {"rho_b_kg_m3", "bulk density", "rho_b", "kg/m\u00b3", 1.0, 1, NULL, "not given", false},
    {"rho_inside_kg_m3", "bulk density away from walls", "rho_inside", "kg/m\u00b3", 1.0, 1,
     NULL, "", false},
    {CLOD_SHEAR_POINTS_WAY, "way of preshear at its end", "", "mm", 1e3, 1, NULL, "", false},
    {CLOD_SHEAR_POINTS_SLOPE, "slope of the shear stress there", "", "kPa/mm", 1e-6, 2, NULL,
     "", false},
    {"flow", "flow (Jenike)", "", "", 1.0, 0, NULL, NULL, true},
    {"r_squared", "fit of the line", "r\u00b2", "", 1.0, 4, NULL, "-", false},
};

const clod_result_row *clod_shear_row_of(const char *key)
{
    size_t k = 0;
    while (strcmp(CLOD_SHEAR_ROWS[k].key, key) != 0) {
        k++;
    }
    return &CLOD_SHEAR_ROWS[k];
}

const json_t *clod_shear_locus(const json_t *study, size_t g)
{
    return json_array_get(json_object_get(study, "loci"), g);
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
                    "deviation) of %.0f specimens",
                    clod_shear_number(locus, "seed_count"));
        } else if (from != NULL && strcmp(from, "fit") == 0) {
            fputs(
                ": &plusmn; one standard error, from scatter about the line and errors of the "
                "points",
                out);
        } else {
            fputs(
                ": no error bars; they need three points, or errors of the points and the preshear",
                out);
        }
        fputs(note != NULL ? "; <strong>" : ".", out);
        clod_html_text(out, note != NULL ? note : "");
        fputs(note != NULL ? "</strong>." : "", out);
        fputs("</p>\n", out);
    }
}

size_t clod_shear_list(const clod_shear_loci *sets, size_t count,
                       clod_result_of of[CLOD_SHEAR_MOST])
{
    size_t used = 0;
    for (size_t s = 0; s < count; s++) {
        const json_t *locus;
        for (size_t g = 0; (locus = clod_shear_locus(sets[s].study, g)) != NULL; g++) {
            if (used < CLOD_SHEAR_MOST) {
                of[used++] = (clod_result_of){.name = sets[s].of, .from = locus};
            }
        }
    }
    return used;
}

static void put_table(FILE *out, const clod_shear_loci *sets, size_t count)
{
    clod_result_of of[CLOD_SHEAR_MOST] = {{.name = NULL}};
    const size_t used = clod_shear_list(sets, count, of);
    clod_result_table_put(clod_writer_page(out), CLOD_SHEAR_ROWS, CLOD_SHEAR_ROW_COUNT, of,
                          used);
    put_notes(out, sets, count);
}

bool clod_shear_put(clod_sheet *sheet, const clod_run_files *run, const json_t *lab,
                    clod_status *status)
{
    clod_shear_points_recall(run);
    clod_shear_loci sets[2];
    size_t count = 0;
    const json_t *study = json_object_get(run->summary, "locus");
    if (study != NULL) {
        sets[count++] = (clod_shear_loci){.of = "simulation", .study = study};
    }
    json_t *beside = lab != NULL ? clod_shear_lab_beside(lab, run, 1) : NULL;
    if (lab != NULL && beside == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the laboratory's points.");
    }
    if (lab != NULL) {
        sets[count++] = (clod_shear_loci){.of = "laboratory", .study = beside, .lab = true};
    }
    if (count > 0) {
        clod_html_section(sheet->body, "results", "Results");
        put_table(sheet->body, sets, count);
        clod_shear_lab_density(clod_writer_page(sheet->body), lab, run, 1);
        clod_shear_figures(sheet, sets, count);
        clod_shear_points_put(sheet->body, run->summary, sets, count);
    }
    json_decref(beside);
    clod_html_section(sheet->body, "curves", "Curves of the test");
    clod_sheet_columns(sheet, true);
    const bool good = clod_shear_curves(sheet, run, status);
    clod_sheet_columns(sheet, false);
    return good && clod_field_slices_put(sheet, run, status) &&
           clod_part_tables_put(sheet, run, status);
}
