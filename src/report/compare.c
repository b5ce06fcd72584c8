/**
 * @file compare.c
 * clod compare: several runs on one page.
 */

#include <stdio.h>
#include <sys/stat.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/compare_keys.h"
#include "report/compare_sources.h"
#include "report/html.h"
#include "report/plain.h"
#include "report/report.h"
#include "report/run_damage.h"
#include "report/run_kinds.h"
#include "report/sheet.h"
#include "report/warnings_section.h"

static bool fail_memory(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
}

/** Refuse a folder that is named twice, by the same path or another one. */
static bool is_new(const clod_report_options *options, size_t k, clod_status *status)
{
    struct stat mine, other;
    for (size_t j = 0; j < k && stat(options->runs[k], &mine) == 0; j++) {
        if (stat(options->runs[j], &other) == 0 && mine.st_dev == other.st_dev &&
            mine.st_ino == other.st_ino) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "%s and %s are the same folder: name each run once.",
                                    options->runs[j], options->runs[k]);
        }
    }
    return true;
}

/** Open all runs, which must be of one kind. */
static bool open_runs(const clod_report_options *options, clod_run_files *runs,
                      clod_status *status)
{
    for (size_t k = 0; k < options->run_count; k++) {
        if (!clod_run_files_open(&runs[k], options->runs[k], status) ||
            !is_new(options, k, status)) {
            return false;
        }
        if (runs[k].kind != runs[0].kind) {
            return clod_status_fail(status, CLOD_USAGE,
                                    "%s is of another kind (%s) than %s (%s): only runs of one "
                                    "kind can be compared.",
                                    runs[k].folder, runs[k].kind->text, runs[0].folder,
                                    runs[0].kind->text);
        }
    }
    clod_run_files_names(runs, options->run_count);
    return true;
}

static void put_head(FILE *out, const clod_run_files *runs, size_t count)
{
    fputs("<header><p class=\"kind\">Comparison</p><h1>", out);
    fprintf(out, "%zu runs: ", count);
    clod_html_text(out, runs[0].kind->text);
    fputs("</h1></header>\n", out);
}

/** @param text  of warnings and results, as clod_plain_put takes it */
static bool put_runs(clod_sheet *sheet, FILE *text, const clod_run_files *runs, size_t count,
                     const json_t *lab, clod_status *status)
{
    const clod_writer out = {sheet->body, text};
    put_head(sheet->body, runs, count);
    if (!clod_warnings_section_put(out, runs, count, true, lab, status)) {
        return false;
    }
    clod_html_section(sheet->body, "results", "Results");
    if (!runs[0].kind->results(out, runs, count, lab, status)) {
        return false;
    }
    clod_html_section(sheet->body, "differences", "What differs between the cases");
    if (!clod_compare_keys_put(sheet->body, runs, count, status)) {
        return false;
    }
    clod_html_section(sheet->body, "figures", "Figures");
    const bool good = runs[0].kind->figures(sheet, runs, count, lab, status);
    clod_compare_sources_put(sheet->body, runs, count);
    return good;
}

/** Make the body of the page. @param plain  [out] owned: warnings and results for a terminal; NULL after a failure */
static bool make(clod_sheet *sheet, char **plain, const clod_run_files *runs, size_t count,
                 const json_t *lab, clod_status *status)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return fail_memory(status);
    }
    const bool good = put_runs(sheet, out, runs, count, lab, status);
    char *raw = clod_text_close(&text);
    out = good && raw != NULL ? clod_text_open(&text) : NULL;
    if (out != NULL) {
        clod_plain_put(out, raw);
        *plain = clod_text_close(&text);
    }
    clod_memory_free(raw);
    return good && (*plain != NULL || fail_memory(status));
}

/** What the caller asked to be told, of a page that is written. */
static void tell(const clod_report_options *options, const clod_run_files *runs,
                 const char *text)
{
    for (size_t k = 0; k < options->run_count; k++) {
        clod_run_damage_tell(&runs[k], options);
    }
    if (options->show != NULL) {
        options->show(text);
    }
}

bool clod_report_compare(const clod_report_options *options, char **path, clod_status *status)
{
    clod_sheet sheet = {0};
    json_t *lab = NULL;
    char *text = NULL;
    *path = NULL;
    clod_run_files *runs = clod_memory_alloc(options->run_count, sizeof *runs);
    bool good = runs != NULL || fail_memory(status);
    good = good && open_runs(options, runs, status);
    if (good && options->lab != NULL) {
        lab = clod_run_kinds_lab(options->lab, &runs[0], status);
        good = lab != NULL;
    }
    good = good && clod_sheet_open(&sheet, status) &&
           make(&sheet, &text, runs, options->run_count, lab, status);
    if (good) {
        *path = clod_memory_text(options->output != NULL ? options->output : "compare.html");
        good = *path != NULL ? clod_sheet_write(&sheet, "Comparison of runs", *path, status)
                             : fail_memory(status);
    }
    if (!good) {
        clod_memory_free(*path);
        *path = NULL;
    }
    if (good) {
        tell(options, runs, text);
    }
    clod_memory_free(text);
    clod_sheet_fini(&sheet);
    json_decref(lab);
    for (size_t k = 0; runs != NULL && k < options->run_count; k++) {
        clod_run_files_fini(&runs[k]);
    }
    clod_memory_free(runs);
    return good;
}
