#include "report/run_damage.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/text.h"
#include "report/result_table.h"
#include "report/table.h"

bool clod_run_damage_add(clod_run_files *self, clod_status *status, const char *format, ...)
{
    char text[CLOD_STATUS_TEXT + 256];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    clod_text_printable(text); // the name of a folder may be any bytes
    return json_array_append_new(self->damage, json_string(text)) == 0 ||
           clod_status_fail(status, CLOD_FAILED, "No memory for the report.");
}

/** Read a table; one with rows of different lengths is listed, and read up to there. */
static bool read_table(clod_run_files *self, const char *name, clod_table *table,
                       clod_status *status)
{
    clod_status why = {0};
    if (clod_table_read(table, self->folder, name, &why)) {
        return true;
    }
    if (why.code != CLOD_USAGE) {
        return clod_status_fail(status, why.code, "%s", why.text);
    }
    return clod_run_damage_add(self, status, "%s", why.text);
}

/** The time in the last row of a table [s]; NaN: it has none. */
static double last_time(const clod_table *table)
{
    const int at = clod_table_find(table, "time");
    if (at < 0 || table->rows == 0) {
        return (double)NAN;
    }
    const char *cell = table->cells[(table->rows - 1) * table->columns + (size_t)at];
    char *end;
    const double last = strtod(cell, &end);
    return end == cell || *end != '\0' ? (double)NAN : last;
}

/** A table with a row at the end of what it is of, as clod writes them. @param step  s, between steps */
static bool look_at_end(clod_run_files *self, const char *name, double end, double step,
                        clod_status *status)
{
    clod_table table;
    bool good = read_table(self, name, &table, status);
    const double last = last_time(&table);
    if (good && isnan(last)) {
        good =
            clod_run_damage_add(self, status,
                                "%s/%s has no rows with a time, or is missing, and the "
                                "simulation went to %.6g s: its curves are left out. Copy the "
                                "file again, or repeat the run with --fresh.",
                                self->folder, name, end);
    } else if (good && last < end - 0.5 * step) {
        good =
            clod_run_damage_add(self, status,
                                "%s/%s ends at %.6g s, and the simulation at %.6g s: the file "
                                "is cut off, and its curves with it. Copy it again, or "
                                "repeat the run with --fresh.",
                                self->folder, name, last, end);
    }
    clod_table_fini(&table);
    return good;
}

static bool look_at_parts(clod_run_files *self, clod_status *status)
{
    bool good = true;
    size_t k;
    const json_t *part;
    json_array_foreach(json_object_get(self->summary, "parts"), k, part)
    {
        const double step = clod_result_table_number(part, "dt_s");
        const double end = step * clod_result_table_number(part, "steps");
        const char *of = json_string_value(json_object_get(part, "part"));
        char name[256];
        snprintf(name, sizeof name, "%s.csv", of != NULL ? of : "");
        if (good && of != NULL && isfinite(end)) {
            good = look_at_end(self, name, end, step, status);
        }
    }
    return good;
}

/** How many rows the table of results has by the summary, and its name; NULL: there is none. */
static const char *expected_points(const json_t *summary, size_t *count)
{
    const json_t *loci = json_object_get(json_object_get(summary, "locus"), "loci");
    const json_t *wall = json_object_get(summary, "wall_locus");
    const json_t *strengths = json_object_get(summary, "flow_function");
    size_t g;
    const json_t *locus;
    *count = 0;
    json_array_foreach(loci, g, locus)
    {
        *count += json_array_size(json_object_get(locus, "points"));
    }
    if (loci != NULL) {
        return "points.csv";
    }
    *count = json_array_size(wall != NULL ? json_object_get(wall, "points") : strengths);
    return wall != NULL ? "wall_friction.csv" : strengths != NULL ? "flow_function.csv" : NULL;
}

static bool look_at_points(clod_run_files *self, clod_status *status)
{
    size_t count;
    const char *name = expected_points(self->summary, &count);
    clod_table table;
    if (name == NULL) {
        return true;
    }
    bool good = read_table(self, name, &table, status);
    const bool there = table.bytes != NULL; // else the page has all points from the summary
    if (good && there && table.rows < count) {
        good = clod_run_damage_add(
            self, status,
            "%s/%s has %zu of the %zu points that summary.json has, which are shown here: the "
            "file is cut off or changed. Copy it again, or repeat the run with --fresh.",
            self->folder, name, table.rows, count);
    }
    clod_table_fini(&table);
    return good;
}

bool clod_run_damage_look(clod_run_files *self, clod_status *status)
{
    self->damage = json_array();
    if (self->damage == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the report.");
    }
    if (self->report == NULL || json_object_get(self->summary, "incomplete") != NULL) {
        return true;
    }
    const double end = clod_result_table_number(self->summary, "time_s");
    const double step = clod_result_table_number(self->summary, "dt_s");
    const bool free = isfinite(end); // a test has its parts
    return (!free || look_at_end(self, "series.csv", end, step, status)) &&
           look_at_parts(self, status) && look_at_points(self, status);
}

void clod_run_damage_tell(const clod_run_files *self, const clod_report_options *options)
{
    size_t k;
    const json_t *text;
    json_array_foreach(self->damage, k, text)
    {
        if (options->tell != NULL) {
            options->tell(json_string_value(text));
        }
    }
}
