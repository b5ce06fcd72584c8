#include "report/part_tables.h"

#include <stdio.h>

#include "report/field_axes.h"
#include "report/field_slices.h"
#include "report/html.h"
#include "report/series_figures.h"
#include "report/summary_tables.h"
#include "report/table.h"

/** Whether it is a mean over a region, or an index: what is not a grid. */
static bool is_shown(const json_t *one)
{
    return json_is_object(one) && json_object_get(one, "cells") == NULL;
}

/** What each part has of this name, with the name of the part; a new list. */
static json_t *collect(const json_t *parts, const char *kind, const char *name)
{
    json_t *list = json_array();
    size_t k;
    json_t *part;
    json_array_foreach(parts, k, part)
    {
        json_t *one = json_object_get(json_object_get(part, kind), name);
        if (is_shown(one)) {
            json_t *copy = json_copy(one);
            json_object_set(copy, "part", json_object_get(part, "part"));
            json_array_append_new(list, copy);
        }
    }
    return list;
}

/** Tables of one kind. @param any  [in,out] whether the section has begun */
static void put_kind(FILE *out, const json_t *parts, const char *kind, const char *title,
                     bool *any)
{
    // all parts measure the same
    json_t *first = json_object_get(json_array_get(parts, 0), kind);
    const char *name;
    json_t *one;
    json_object_foreach(first, name, one)
    {
        if (is_shown(one)) {
            char heading[128];
            json_t *list = collect(parts, kind, name);
            snprintf(heading, sizeof heading, "%s %.96s", title, name);
            if (!*any) {
                clod_html_section(out, "part-means", "Fields and mixing of the parts");
                fputs("<p class=\"note\">&plusmn; one standard deviation of the means of ten "
                      "blocks. Means of fields, and mean of an index, are those of the rows in "
                      "the last third of the phase; the other numbers of an index are those at "
                      "the end of the part.</p>\n",
                      out);
                *any = true;
            }
            clod_summary_tables_put(out, heading, NULL, list);
            json_decref(list);
        }
    }
}

/** The curves of the part whose slices are shown, folded; nothing when it has no means over regions. */
static bool put_curves(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    const char *part, *field;
    json_t *one;
    bool any = false;
    json_object_foreach(clod_field_slices_grids(run, &part), field, one)
    {
        any = any || is_shown(one);
    }
    if (part == NULL || !any) {
        return true;
    }
    clod_table table;
    char name[256];
    snprintf(name, sizeof name, "%s.csv", part);
    const bool good = clod_table_read(&table, run->folder, name, status);
    if (good) {
        fputs("<details class=\"more\"><summary>More curves: fields in ", sheet->body);
        clod_html_text(sheet->body, part);
        fputs("</summary>\n", sheet->body);
        clod_sheet_columns(sheet, true);
        clod_series_figures_fields(sheet, &table);
        clod_sheet_columns(sheet, false);
        fputs("</details>\n", sheet->body);
    }
    clod_table_fini(&table);
    return good;
}

bool clod_part_tables_put(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    const json_t *parts = json_object_get(run->summary, "parts");
    bool any = false;
    clod_field_axes_set(run);
    put_kind(sheet->body, parts, "fields", "Field", &any);
    put_kind(sheet->body, parts, "mixing", "Mixing", &any);
    return put_curves(sheet, run, status);
}
