#include "report/run_pages.h"

#include <math.h>
#include <stdio.h>

#include "clod/locus.h"
#include "report/field_slices.h"
#include "report/flow_figure.h"
#include "report/html.h"
#include "report/part_curves.h"
#include "report/part_tables.h"
#include "report/shear_rows.h"
#include "report/uniaxial_rows.h"

#define MOST_STRESSES 64

const clod_result_row CLOD_UNIAXIAL_ROWS[CLOD_UNIAXIAL_ROW_COUNT] = {
    {"sigma_1_Pa", "major principal stress", "sigma_1", "kPa", 1e-3, 3, NULL, NULL, false},
    {"sigma_c_Pa", "unconfined yield strength", "sigma_c", "kPa", 1e-3, 3, "sigma_c_error_Pa",
     NULL, false},
    {"ffc", "flowability $sigma_1$/$sigma_c$", "ff_c", "", 1.0, 2, NULL, NULL, false},
    {"strain_at_peak", "strain at the peak", "", "%", 100.0, 2, NULL, NULL, false},
    {"bulk_density_kg_m3", "bulk density", "rho_b", "kg/m\u00b3", 1.0, 0, NULL, NULL, false},
    {"inside_density_kg_m3", "bulk density away from walls", "rho_inside", "kg/m\u00b3", 1.0, 0,
     NULL, "", false},
    {"solid_fraction", "solid fraction", "", "", 1.0, 4, NULL, NULL, false},
    {"void_ratio", "void ratio", "e", "", 1.0, 4, NULL, NULL, false}};

/** Results of each consolidation beside each other. */
static void put_results(FILE *out, const json_t *strengths)
{
    clod_result_of of[MOST_STRESSES];
    char names[MOST_STRESSES][32];
    size_t count = 0;
    size_t k;
    const json_t *one;
    json_array_foreach(strengths, k, one)
    {
        if (count < MOST_STRESSES) {
            snprintf(names[count], sizeof names[count], "%.6g kPa",
                     1e-3 * clod_result_table_number(one, "consolidation_stress_Pa"));
            of[count] = (clod_result_of){.name = names[count], .from = one};
            count++;
        }
    }
    clod_result_table_put(clod_writer_page(out), CLOD_UNIAXIAL_ROWS, CLOD_UNIAXIAL_ROW_COUNT,
                          of, count);
}

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

static bool put_curves(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    static const clod_part_column COLUMNS[] = {{"axial_stress", "axial stress", "kPa", 1e-3},
                                               {"bulk_density", "bulk density", "kg/m3", 1.0}};
    const clod_part_curves curves = {.part = "stress-",
                                     .over = {"strain", "axial strain", "%", 100.0},
                                     .behind = " over strain",
                                     .columns = COLUMNS,
                                     .count = sizeof COLUMNS / sizeof COLUMNS[0]};
    return clod_part_curves_put(sheet, run, &curves, status);
}

bool clod_run_pages_uniaxial(clod_sheet *sheet, const clod_run_files *run, const json_t *lab,
                             clod_status *status)
{
    (void)lab;
    json_t *strengths = json_object_get(run->summary, "flow_function");
    clod_html_section(sheet->body, "results", "Results");
    put_results(sheet->body, strengths);
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
    return good && clod_field_slices_put(sheet, run, status) &&
           clod_part_tables_put(sheet, run, status);
}
