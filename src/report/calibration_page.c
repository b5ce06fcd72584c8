#include "report/calibration_page.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/input.h"
#include "base/json.h"
#include "base/memory.h"
#include "clod/version.h"
#include "report/calibration_figures.h"
#include "report/figure_json.h"
#include "report/html.h"
#include "report/rounded.h"
#include "report/shear_rows.h"

#define MOST_BYTES ((size_t)1 << 26)

bool clod_calibration_page_is(const char *folder)
{
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/calibration.json", folder);
    return access(path, F_OK) == 0;
}

/** Begin a table; heads are parted by bars. */
static void put_heads(FILE *out, const char *heads)
{
    fputs("<div class=\"scroll\"><table class=\"copied\"><thead><tr><th>", out);
    for (const char *at = heads; *at != '\0'; at++) {
        if (*at == '|') {
            fputs("</th><th>", out);
        } else {
            fputc(*at, out);
        }
    }
    fputs("</th></tr></thead>\n<tbody>", out);
}

/** "name [unit]" as the head of a row. */
static void put_name(FILE *out, const char *name, const json_t *about)
{
    const char *unit = json_string_value(json_object_get(about, "unit"));
    fputs("<tr><th>", out);
    clod_html_text(out, name);
    if (unit != NULL && unit[0] != '\0' && strcmp(unit, "1") != 0) {
        fputs(" [", out);
        clod_html_text(out, unit);
        fputs("]", out);
    }
    fputs("</th>", out);
}

/** A number with four digits, or with those of what it is uncertain by. */
static void put_number(FILE *out, const json_t *from, const char *key, double error)
{
    const double value = clod_shear_number(from, key), none = (double)NAN;
    clod_rounded_begin(out, "td", value, none, "");
    if (isfinite(value) && error > 0.0) {
        char text[48];
        clod_rounded_text(text, clod_rounded_of(value, error, 3), value);
        fputs(text, out);
    } else if (isfinite(value)) {
        clod_rounded_put(clod_writer_page(out), value, none, none, CLOD_ROUNDED_SHORT, "");
    }
    fputs("</td>", out);
}

static void put_word(FILE *out, const json_t *from, const char *key)
{
    clod_html_cell(out, "td", json_string_value(json_object_get(from, key)));
}

/** Half of the interval: its digits are those of the mean. */
static double half_of(const json_t *from)
{
    return 0.5 * (clod_shear_number(from, "high") - clod_shear_number(from, "low"));
}

static void put_range(FILE *out, const json_t *from)
{
    const double low = clod_shear_number(from, "low"), high = clod_shear_number(from, "high");
    char text[2][48];
    if (isfinite(low) && isfinite(high)) {
        const clod_rounded how = clod_rounded_of(high, 0.5 * (high - low), 3);
        clod_rounded_text(text[0], how, low);
        clod_rounded_text(text[1], how, high);
        fprintf(out, "%s&nbsp;to&nbsp;%s", text[0], text[1]);
    }
}

/** "0.485 to 0.599", with the whole numbers as the title of a cell. */
static void put_interval(FILE *out, const json_t *from)
{
    const double low = clod_shear_number(from, "low"), high = clod_shear_number(from, "high");
    if (!isfinite(low) || !isfinite(high)) {
        fputs("<td></td>", out);
        return;
    }
    fputs("<td title=\"", out);
    clod_figure_json_number(out, low);
    fputs(" to ", out);
    clod_figure_json_number(out, high);
    fputs("\">", out);
    put_range(out, from);
    fputs("</td>", out);
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
        const double value = clod_shear_number(target, "measured");
        const double error = clod_shear_number(target, "error");
        const char *unit = json_string_value(json_object_get(target, "unit"));
        if (json_is_true(json_object_get(target, "held_back")) != held_back) {
            continue;
        }
        if (!begun) {
            fprintf(out, "<h3>%s</h3>\n", title);
            put_heads(
                out,
                "target|measured|discrepancy|model|interval|at the card's values|off, in deviations");
        }
        begun = true;
        put_name(out, name_of(target), target);
        clod_rounded_begin(out, "td", value, error, unit != NULL ? unit : "");
        clod_rounded_put(clod_writer_page(out), value, error, (double)NAN, CLOD_ROUNDED_SHORT,
                         "");
        fputs("</td>", out);
        put_number(out, target, "discrepancy", (double)NAN);
        put_number(out, target, "model", half_of(target));
        put_interval(out, target);
        put_number(out, target, "card", half_of(target));
        put_number(out, target, "off", 0.1);
        fputs("</tr>\n", out);
    }
    fputs(begun ? "</tbody></table></div>\n" : "", out);
}

static void put_parameters(FILE *out, const json_t *result)
{
    const char *name;
    const json_t *one;
    put_heads(
        out,
        "parameter|mean|interval|on the card|prior range|scale|width over the range's|identified by "
        "the targets|R-hat|independent samples");
    json_object_foreach(json_object_get(result, "parameters"), name, one)
    {
        put_name(out, name, one);
        put_number(out, one, "mean", half_of(one));
        put_interval(out, one);
        put_number(out, one, "card", half_of(one));
        fprintf(out, "<td>%.4g&nbsp;to&nbsp;%.4g</td>", clod_shear_number(one, "from"),
                clod_shear_number(one, "to"));
        put_word(out, one, "scale");
        put_number(out, one, "relative_width", 0.1);
        put_word(out, one, "identified");
        put_number(out, one, "rhat", 0.01);
        put_number(out, one, "effective_samples", 10.0);
        fputs("</tr>\n", out);
    }
    fputs("</tbody></table></div>\n", out);
}

static void put_surrogates(FILE *out, const json_t *result)
{
    size_t k;
    const json_t *one;
    fputs("<h3>Surrogates, each point predicted by the others</h3>\n", out);
    put_heads(
        out,
        "target|surrogate|runs|between packings, at the means|least in the ranges|greatest|"
        "error of left-out points|Q2|within two deviations");
    json_array_foreach(json_object_get(result, "targets"), k, one)
    {
        const json_t *about = json_object_get(one, "surrogate");
        put_name(out, name_of(one), one);
        put_word(out, about, "kind");
        put_number(out, about, "runs", (double)NAN);
        put_number(out, about, "packing_deviation", (double)NAN);
        put_number(out, about, "least_packing_deviation", (double)NAN);
        put_number(out, about, "greatest_packing_deviation", (double)NAN);
        put_number(out, about, "left_out_error", (double)NAN);
        put_number(out, about, "q2", 0.1);
        put_number(out, about, "within_two_deviations", 0.1);
        fputs("</tr>\n", out);
    }
    fputs("</tbody></table></div>\n", out);
}

static void put_tables(FILE *out, const json_t *result)
{
    clod_html_section(out, "results", "Numbers");
    put_parameters(out, result);
    put_targets(out, result, false, "Targets that were used");
    put_targets(out, result, true, "Targets that were held back, predicted");
    fprintf(out,
            "<p class=\"note\">Intervals: %.3g %%; of a target, of what a laboratory "
            "would measure. Posterior predictive p = %.2g, chi-square %.3g.</p>\n",
            100.0 * clod_shear_number(result, "level"), clod_shear_number(result, "p_value"),
            clod_shear_number(result, "chi_square"));
    put_surrogates(out, result);
}

static bool is_apart(const json_t *result)
{
    return json_is_true(json_object_get(result, "chains_apart"));
}

/** Each parameter: mean and interval. */
static void put_cards(FILE *out, const json_t *result)
{
    const double level = 100.0 * clod_shear_number(result, "level"), none = (double)NAN;
    const char *name;
    const json_t *one;
    fputs("<div class=\"cards\">\n", out);
    if (is_apart(result)) {
        fputs(
            "<div class=\"card\"><b>no result</b><span>the Markov chains lie apart: there are no means and no "
            "intervals</span></div>\n",
            out);
    }
    json_object_foreach(is_apart(result) ? NULL : json_object_get(result, "parameters"), name,
                        one)
    {
        const double mean = clod_shear_number(one, "mean");
        const char *unit = json_string_value(json_object_get(one, "unit"));
        const char *identified = json_string_value(json_object_get(one, "identified"));
        char text[48];
        fputs("<div class=\"card\">", out);
        clod_rounded_begin(out, "b", mean, none, unit != NULL ? unit : "");
        clod_rounded_text(text, clod_rounded_of(mean, half_of(one), 3), mean);
        fprintf(out, "%s <small>", text);
        clod_html_text(out, unit != NULL ? unit : "");
        fputs("</small></b><span>", out);
        clod_html_text(out, name);
        fprintf(out, "; %.3g %% interval ", level);
        put_range(out, one);
        fputs("; identified: ", out);
        clod_html_text(out, identified);
        fputs("</span></div>\n", out);
    }
    const double p = clod_shear_number(result, "p_value");
    if (isfinite(p)) {
        const char *verdict = json_string_value(json_object_get(result, "card_targets"));
        fprintf(
            out,
            "<div class=\"card\"><b>%.2g</b><span>posterior predictive p of the targets: %s"
            "</span></div>\n",
            p,
            verdict != NULL && strcmp(verdict, "untold") == 0
                ? "it does not tell whether the card meets them, since surrogates are less sure than the laboratory; "
                  "run the tests with the card"
                : "below 0.05 the model does not reach them, and no parameter is identified");
    }
    fputs("</div>\n", out);
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

/** The version of clod that made the runs: the second line of design.txt; "" if there is none. */
static void read_version(const char *folder, char version[160])
{
    static const char BEGIN[] = "\nclod ";
    char path[PATH_MAX];
    char *text;
    size_t length;
    clod_status none = {CLOD_OK, ""};
    version[0] = '\0';
    snprintf(path, sizeof path, "%s/design.txt", folder);
    if (clod_input_read_regular(path, MOST_BYTES, &text, &length, &none)) {
        const char *at = strstr(text, BEGIN);
        if (at != NULL) {
            at += strlen(BEGIN);
            snprintf(version, 160, "%.*s", (int)strcspn(at, "\n"), at);
        }
        clod_memory_free(text);
    }
}

/** When calibration.json was written, UTC: as it says, or else the time of the file. */
static void read_time(const char *folder, const json_t *result, char text[40])
{
    const char *written = json_string_value(json_object_get(result, "written"));
    if (written != NULL && strlen(written) >= strlen("2026-11-28T03:02") &&
        written[strspn(written, "0123456789-T:.Z")] == '\0') {
        snprintf(text, 40, "%.10s %.5s UTC", written, written + strlen("2026-11-28T"));
        return;
    }
    char path[PATH_MAX];
    struct stat about;
    struct tm parts;
    snprintf(path, sizeof path, "%s/calibration.json", folder);
    if (stat(path, &about) != 0 || gmtime_r(&about.st_mtime, &parts) == NULL ||
        strftime(text, 40, "%Y-%m-%d %H:%M UTC", &parts) == 0) {
        snprintf(text, 40, "not known");
    }
}

static void put_sources(FILE *out, const char *folder, const json_t *result)
{
    static const struct {
        const char *key, *text;
    } NUMBERS[] = {{"points", "points of the design"},
                   {"packings", "packings of each"},
                   {"failed_runs", "runs that failed"}};
    char version[160], text[64];
    clod_html_section(out, "provenance", "Where this comes from");
    fputs("<div class=\"scroll\"><table class=\"facts\">", out);
    clod_html_fact(out, "results folder", folder);
    read_version(folder, version);
    clod_html_fact(out, "runs computed by", version[0] != '\0' ? version : "not known");
    const char *by = json_string_value(json_object_get(result, "version"));
    if (by != NULL) { // earlier versions did not write it
        clod_html_fact(out, "calibrated by", by);
    }
    read_time(folder, result, text);
    clod_html_fact(out, "calibration.json written", text);
    clod_html_fact(out, "page written by", clod_version_text());
    clod_html_fact(out, "plan", json_string_value(json_object_get(result, "plan")));
    for (size_t k = 0; k < sizeof NUMBERS / sizeof *NUMBERS; k++) {
        const double number = clod_shear_number(result, NUMBERS[k].key);
        if (isfinite(number)) {
            snprintf(text, sizeof text, "%.0f", number);
            clod_html_fact(out, NUMBERS[k].text, text);
        }
    }
    fputs("</table></div>\n", out);
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
    char time[40];
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
    read_time(folder, result, time);
    fprintf(sheet->body, ", computed until %s</p></header>\n", time);
    put_warnings(sheet->body, result);
    put_cards(sheet->body, result);
    good = good && (is_apart(result) ||
                    clod_calibration_figures_posterior(sheet, folder, result, status));
    put_tables(sheet->body, result);
    good = good && clod_calibration_figures_targets(sheet, folder, result, status);
    put_sources(sheet->body, folder, result);
    put_texts(sheet->body, folder);
    json_decref(result);
    return good;
}
