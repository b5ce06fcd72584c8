/**
 * @file compare.c
 * clod compare: several runs on one page.
 */

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "report/compare_tables.h"
#include "report/html.h"
#include "report/report.h"
#include "report/series_compare.h"
#include "report/shear.h"
#include "report/shear_rows.h"
#include "report/sheet.h"
#include "report/wall_page.h"

static bool fail_memory(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
}

/** Open all runs, which must be of one kind. */
static bool open_runs(const clod_report_options *options, clod_run_files *runs,
                      clod_status *status)
{
    for (size_t k = 0; k < options->run_count; k++) {
        if (!clod_run_files_open(&runs[k], options->runs[k], status)) {
            return false;
        }
        if (strcmp(runs[k].kind_text, runs[0].kind_text) != 0) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "%s is of another kind (%s) than %s (%s): only runs of one "
                                    "kind can be compared.",
                                    runs[k].folder, runs[k].kind_text, runs[0].folder,
                                    runs[0].kind_text);
        }
    }
    clod_run_files_names(runs, options->run_count);
    return true;
}

static void put_head(FILE *out, const clod_run_files *runs, size_t count)
{
    fputs("<header><p class=\"kind\">Comparison</p><h1>", out);
    fprintf(out, "%zu runs: ", count);
    clod_html_text(out, runs[0].kind_text);
    fputs("</h1></header>\n", out);
    bool any = false;
    for (size_t k = 0; k < count; k++) {
        any = any || runs[k].report == NULL;
    }
    if (any) {
        fputs("<section class=\"warnings\"><h2>Not complete</h2><ul>", out);
        for (size_t k = 0; k < count; k++) {
            if (runs[k].report == NULL) {
                clod_html_cell(out, "li", runs[k].folder);
            }
        }
        fputs("</ul></section>\n", out);
    }
}

/** Yield loci over each other, and the curves of all preshears. */
static bool put_shear(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                      const json_t *lab, clod_status *status)
{
    clod_shear_loci *sets = clod_memory_alloc(count + 1, sizeof *sets);
    size_t used = 0;
    if (sets == NULL) {
        return fail_memory(status);
    }
    for (size_t k = 0; k < count; k++) {
        const json_t *study = json_object_get(runs[k].summary, "locus");
        if (study != NULL) {
            sets[used++] = (clod_shear_loci){.of = runs[k].name, .study = study};
        }
    }
    if (lab != NULL) {
        sets[used++] = (clod_shear_loci){.of = "laboratory", .study = lab, .lab = true};
    }
    clod_html_section(sheet->body, "figures", "Figures");
    if (used > 0) {
        clod_shear_figures(sheet, sets, used);
    }
    clod_memory_free(sets);
    clod_sheet_columns(sheet, true);
    const bool good = clod_series_compare_parts(sheet, runs, count, "preshear", "displacement",
                                                "shear_stress", status) &&
                      clod_series_compare_parts(sheet, runs, count, "preshear", "displacement",
                                                "bulk_density", status);
    clod_sheet_columns(sheet, false);
    return good;
}

/** Wall yield loci in a table and over each other, and the curves of all. */
static bool put_walls(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                      const json_t *lab, clod_status *status)
{
    clod_wall_page_locus *loci = clod_memory_alloc(count + 1, sizeof *loci);
    size_t used = 0;
    if (loci == NULL) {
        return fail_memory(status);
    }
    for (size_t k = 0; k < count; k++) {
        const json_t *locus = json_object_get(runs[k].summary, "wall_locus");
        if (json_is_object(locus)) {
            loci[used++] = (clod_wall_page_locus){.of = runs[k].name, .locus = locus};
        }
    }
    if (lab != NULL) {
        loci[used++] = (clod_wall_page_locus){.of = "laboratory", .locus = lab, .lab = true};
    }
    clod_html_section(sheet->body, "results", "Results");
    clod_wall_page_table(sheet->body, loci, used);
    clod_html_section(sheet->body, "differences", "What differs between the cases");
    bool good = clod_compare_tables_keys(sheet->body, runs, count, status);
    clod_html_section(sheet->body, "figures", "Figures");
    clod_wall_page_figures(sheet, loci, used);
    clod_memory_free(loci);
    clod_sheet_columns(sheet, true);
    good = good && clod_series_compare_parts(sheet, runs, count, "wall", "displacement",
                                             "shear_stress", status);
    clod_sheet_columns(sheet, false);
    return good;
}

static bool put_runs(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                     const json_t *lab, clod_status *status)
{
    put_head(sheet->body, runs, count);
    if (runs[0].kind == CLOD_RUN_WALL) {
        return put_walls(sheet, runs, count, lab, status);
    }
    clod_html_section(sheet->body, "results", "Results");
    clod_compare_tables_results(sheet->body, runs, count, lab);
    clod_html_section(sheet->body, "differences", "What differs between the cases");
    bool good = clod_compare_tables_keys(sheet->body, runs, count, status);
    if (good && runs[0].kind == CLOD_RUN_SHEAR) {
        good = put_shear(sheet, runs, count, lab, status);
    } else if (good) {
        clod_html_section(sheet->body, "figures", "Figures");
        clod_sheet_columns(sheet, true);
        good = runs[0].kind == CLOD_RUN_UNIAXIAL
                   ? clod_series_compare_strengths(sheet, runs, count, status)
                   : clod_series_compare_free(sheet, runs, count, status);
        clod_sheet_columns(sheet, false);
    }
    return good;
}

bool clod_report_compare(const clod_report_options *options, char **path, clod_status *status)
{
    clod_sheet sheet = {0};
    json_t *lab = NULL;
    *path = NULL;
    clod_run_files *runs = clod_memory_alloc(options->run_count, sizeof *runs);
    bool good = runs != NULL || fail_memory(status);
    good = good && open_runs(options, runs, status);
    if (good && options->lab != NULL) {
        lab = runs[0].kind == CLOD_RUN_WALL ? clod_wall_page_lab(options->lab, status)
                                            : clod_shear_lab(options->lab, &runs[0], status);
        good = lab != NULL;
    }
    good = good && clod_sheet_open(&sheet, status) &&
           put_runs(&sheet, runs, options->run_count, lab, status);
    if (good) {
        *path = clod_memory_text(options->output != NULL ? options->output : "compare.html");
        good = *path != NULL ? clod_sheet_write(&sheet, "Comparison of runs", *path, status)
                             : fail_memory(status);
    }
    if (!good) {
        clod_memory_free(*path);
        *path = NULL;
    }
    clod_sheet_fini(&sheet);
    json_decref(lab);
    for (size_t k = 0; runs != NULL && k < options->run_count; k++) {
        clod_run_files_fini(&runs[k]);
    }
    clod_memory_free(runs);
    return good;
}
