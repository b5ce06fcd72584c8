#include "report/compare_sources.h"

#include <math.h>
#include <stdio.h>

#include "clod/version.h"
#include "report/head.h"
#include "report/html.h"
#include "report/rounded.h"

static void put_number(FILE *out, const json_t *summary, const char *key)
{
    double ends[2];
    if (!clod_head_number(summary, key, ends)) {
        clod_html_cell(out, "td", "");
        return;
    }
    const double none = (double)NAN;
    const bool whole = ends[0] == floor(ends[0]) && ends[1] == floor(ends[1]); // seeds, grains
    const int digits = whole ? 0 : CLOD_ROUNDED_SHORT;
    clod_rounded_begin(out, "td", ends[0], none, "");
    clod_rounded_put(clod_writer_page(out), ends[0], none, none, digits, "");
    if (ends[0] != ends[1]) {
        fputs(" to ", out);
        clod_rounded_put(clod_writer_page(out), ends[1], none, none, digits, "");
    }
    fputs("</td>", out);
}

void clod_compare_sources_put(FILE *out, const clod_run_files *runs, size_t count)
{
    static const char *const NUMBERS[] = {"seed", "grains", "dt_s", "wall_clock_s"};
    clod_html_section(out, "provenance", "Where this comes from");
    fputs(
        "<div class=\"scroll\"><table class=\"sources\" id=\"sources-table\"><thead><tr><th>results "
        "folder</th><th>computed by</th><th>until</th><th>seed</th>"
        "<th>grains</th><th>time step [s]</th><th>computing time [s]</th></tr></thead>\n<tbody>",
        out);
    for (size_t k = 0; k < count; k++) {
        const char *version = clod_run_files_version(&runs[k]);
        char until[40] = "not known";
        if (runs[k].ended != NULL) {
            snprintf(until, sizeof until, "%.10s %.5s UTC", runs[k].ended, runs[k].ended + 11);
        }
        fputs("<tr>", out);
        clod_html_cell(out, "th", runs[k].folder);
        clod_html_cell(out, "td", version != NULL ? version : "not known");
        clod_html_cell(out, "td", until);
        for (size_t n = 0; n < sizeof NUMBERS / sizeof *NUMBERS; n++) {
            put_number(out, runs[k].summary, NUMBERS[n]);
        }
        fputs("</tr>\n", out);
    }
    fputs("</tbody></table></div>\n<p class=\"note\">This page was written by ", out);
    clod_html_text(out, clod_version_text());
    fputs(".</p>\n", out);
}
