#include "report/head.h"

#include <math.h>
#include <string.h>

#include "report/free_warnings.h"
#include "report/html.h"
#include "report/run_kinds.h"
#include "report/shear.h"
#include "report/shear_rows.h"

void clod_head_put(FILE *out, const clod_run_files *run)
{
    fputs("<header><p class=\"kind\">", out);
    clod_html_text(out, run->kind->text);
    fputs("</p><h1>", out);
    clod_html_text(out, run->title);
    fputs("</h1><p class=\"when\">", out);
    clod_html_text(out, run->folder);
    if (run->ended != NULL) {
        fputs(run->report != NULL ? ", computed until " : ", computed so far until ", out);
        fprintf(out, "%.10s %.5s UTC", run->ended, run->ended + 11);
    }
    fputs("</p></header>\n", out);
}

/** Warnings, each behind the same words; how many. */
static size_t put_list(FILE *out, const char *before, const json_t *list)
{
    size_t k;
    const json_t *text;
    json_array_foreach(list, k, text)
    {
        const char *words = json_string_value(text);
        fprintf(out, "%s%s%c", before, words != NULL ? words : "", '\0');
    }
    return json_array_size(list);
}

/** Warnings of an evaluation. @param named  each with the preshear stress of its locus */
static size_t put_study(FILE *out, const json_t *study, bool named)
{
    size_t count = 0;
    size_t g;
    const json_t *locus;
    json_array_foreach(json_object_get(study, "loci"), g, locus)
    {
        const double stress = clod_shear_number(locus, "sigma_p_Pa");
        char before[96] = "";
        if (named && isfinite(stress)) {
            snprintf(before, sizeof before,
                     "Yield locus at a preshear stress of %.3f kPa: ", 1e-3 * stress);
        }
        count += put_list(out, before, json_object_get(locus, "warnings"));
    }
    return count + put_list(out, "", json_object_get(study, "warnings"));
}

size_t clod_head_warnings(FILE *out, const clod_run_files *run, const json_t *lab)
{
    const char *incomplete = json_string_value(json_object_get(run->summary, "incomplete"));
    if (run->report == NULL) {
        fprintf(out, "The run is not complete: this page shows what there is so far.%c", '\0');
    }
    if (incomplete != NULL) {
        fprintf(out, "%s%c", incomplete, '\0');
    }
    return (size_t)(run->report == NULL) + (size_t)(incomplete != NULL) +
           put_list(out, "", run->damage) +
           put_study(out, json_object_get(run->summary, "locus"), false) +
           put_list(out, "", json_object_get(run->summary, "warnings")) +
           clod_free_warnings_put(out, run->summary) + clod_shear_lab_warnings(out, run, lab);
}

size_t clod_head_lab_warnings(FILE *out, const json_t *lab)
{
    return put_study(out, lab, true);
}

bool clod_head_number(const json_t *summary, const char *key, double ends[2])
{
    const json_t *own = json_object_get(summary, key);
    if (own != NULL || strcmp(key, "steps") == 0) {
        ends[0] = ends[1] = json_number_value(own);
        return json_is_number(own);
    }
    double sum = 0.0;
    ends[0] = HUGE_VAL;
    ends[1] = -HUGE_VAL;
    size_t k;
    const json_t *part;
    json_array_foreach(json_object_get(summary, "parts"), k, part)
    {
        const json_t *number = json_object_get(part, key);
        if (json_is_number(number)) {
            const double value = json_number_value(number);
            sum += value;
            ends[0] = fmin(ends[0], value);
            ends[1] = fmax(ends[1], value);
        }
    }
    const bool found = ends[0] <= ends[1];
    if (found && strcmp(key, "wall_clock_s") == 0) {
        ends[0] = ends[1] = sum;
    }
    return found;
}

void clod_head_sources(FILE *out, const clod_run_files *run)
{
    static const struct {
        const char *key, *text, *format;
    } NUMBERS[] = {{"grains", "grains", "%.0f"},
                   {"seed", "seed", "%.0f"},
                   {"dt_s", "time step [s]", "%.4g"},
                   {"steps", "steps", "%.0f"},
                   {"wall_clock_s", "computing time [s]", "%.4g"}};
    clod_html_section(out, "provenance", "Where this comes from");
    fputs("<div class=\"scroll\"><table class=\"facts\">", out);
    clod_html_fact(out, "results folder", run->folder);
    const char *version = clod_run_files_version(run);
    clod_html_fact(out, "computed by", version != NULL ? version : "not known");
    clod_html_fact(out, "begun", run->began != NULL ? run->began : "not known");
    clod_html_fact(out, "last entry of the log", run->ended != NULL ? run->ended : "not known");
    for (size_t k = 0; k < sizeof NUMBERS / sizeof *NUMBERS; k++) {
        double ends[2];
        if (clod_head_number(run->summary, NUMBERS[k].key, ends)) {
            char low[32], high[32], text[80];
            snprintf(low, sizeof low, NUMBERS[k].format, ends[0]);
            snprintf(high, sizeof high, NUMBERS[k].format, ends[1]);
            const bool one = strcmp(low, high) == 0;
            snprintf(text, sizeof text, "%s%s%s", low, one ? "" : " to ", one ? "" : high);
            clod_html_fact(out, NUMBERS[k].text, text);
        }
    }
    fputs("</table></div>\n", out);
    if (run->report != NULL) {
        clod_html_folded(out, "The whole report as text (report.txt)", run->report);
    }
    if (run->case_text != NULL) {
        clod_html_folded(out, "The case (case.yaml)", run->case_text);
    }
    clod_html_folded(out, "The case with all defaults (case-complete.yaml)", run->complete);
}
